// Puts exact-ccd in the place of the methods of the IPC Toolkit, in a source that names them: the
// compiler includes this header first. Their tolerances and numbers of iterations have no influence.
// Default arguments of the toolkit keep its own method.

#include <ipc/ccd/additive_ccd.hpp>
#include <ipc/ccd/tight_inclusion_ccd.hpp>
#include <ipc/ipc.hpp>

#include <exact_ccd/ipc_toolkit.hpp>

namespace ipc {

// Tight Inclusion rescales a distance of 10⁻⁴ at most. Here nothing is rescaled.
struct ExactAsTightInclusion : exact_ccd::ExactCCD {
    static constexpr double DEFAULT_TOLERANCE = TightInclusionCCD::DEFAULT_TOLERANCE;
    static constexpr long DEFAULT_MAX_ITERATIONS = TightInclusionCCD::DEFAULT_MAX_ITERATIONS;

    explicit ExactAsTightInclusion(double /* tolerance */ = DEFAULT_TOLERANCE,
                                   long /* max_iterations */ = DEFAULT_MAX_ITERATIONS,
                                   double /* rescaling */ = 1.0)
        : ExactCCD(1.0)
    {
    }
};

struct ExactAsAdditive : exact_ccd::ExactCCD {
    static constexpr long DEFAULT_MAX_ITERATIONS = AdditiveCCD::DEFAULT_MAX_ITERATIONS;
    static constexpr long UNLIMITTED_ITERATIONS = AdditiveCCD::UNLIMITTED_ITERATIONS;

    explicit ExactAsAdditive(long /* max_iterations */ = UNLIMITTED_ITERATIONS,
                             double rescaling = AdditiveCCD::DEFAULT_CONSERVATIVE_RESCALING)
        : ExactCCD(rescaling)
    {
    }
};

}  // namespace ipc

#define TightInclusionCCD ExactAsTightInclusion
#define AdditiveCCD ExactAsAdditive
