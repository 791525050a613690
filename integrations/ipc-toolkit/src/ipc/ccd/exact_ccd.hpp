#pragma once

#include <exact_ccd/ipc_toolkit.hpp>

namespace ipc {

/// @brief Continuous collision detection without false positives and without false negatives, for all finite input.
///
/// The time of impact is exact and rounded down. As a step of exactly that size may end in contact, the result is that time
/// times `conservative_rescaling`. If the primitives are within `min_distance` at the start, it is 0.
/// Input that is not finite throws std::runtime_error.
using ExactCCD = ::exact_ccd::ExactCCD;

} // namespace ipc
