#pragma once

#include <memory>
#include <string>

#include <ipc/ccd/narrow_phase_ccd.hpp>

namespace polyfem::solver
{
	/// @brief The continuous collision detection of pairs of primitives by its name in the JSON input.
	/// @param method "tight_inclusion", or "exact", which needs an IPC Toolkit with exact-ccd
	/// @param tolerance Tolerance of Tight Inclusion; without effect on "exact"
	/// @param max_iterations Maximum number of iterations of Tight Inclusion; without effect on "exact"
	/// @throws std::runtime_error if there is no such method, or if this build does not have it
	std::unique_ptr<const ipc::NarrowPhaseCCD>
	make_narrow_phase(const std::string &method, double tolerance, long max_iterations);
} // namespace polyfem::solver
