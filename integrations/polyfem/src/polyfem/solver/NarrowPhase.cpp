#include "NarrowPhase.hpp"

#include <stdexcept>

#include <ipc/config.hpp>
#include <ipc/ccd/tight_inclusion_ccd.hpp>

#ifdef IPC_TOOLKIT_WITH_EXACT_CCD
#include <ipc/ccd/exact_ccd.hpp>
#endif

namespace polyfem::solver
{
	std::unique_ptr<const ipc::NarrowPhaseCCD>
	make_narrow_phase(const std::string &method, double tolerance, long max_iterations)
	{
		if (method == "tight_inclusion")
			return std::make_unique<ipc::TightInclusionCCD>(tolerance, max_iterations);
		if (method == "exact")
		{
#ifdef IPC_TOOLKIT_WITH_EXACT_CCD
			return std::make_unique<ipc::ExactCCD>();
#else
			throw std::runtime_error("/solver/contact/CCD/method is \"exact\": build with IPC_TOOLKIT_WITH_EXACT_CCD=ON");
#endif
		}
		throw std::runtime_error("/solver/contact/CCD/method is \"" + method + "\", expected \"tight_inclusion\" or \"exact\"");
	}
} // namespace polyfem::solver
