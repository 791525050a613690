#include <polyfem/solver/NarrowPhase.hpp>

#include <catch2/catch_test_macros.hpp>

#include <limits>
#include <string>
#include <vector>

#include <ipc/config.hpp>

using polyfem::solver::make_narrow_phase;

TEST_CASE("narrow phases by name", "[contact][ccd]")
{
	// An edge that moves through another at t = 1/2, and one that stays away.
	const Eigen::Vector3d a0(-1, 0, 0), a1(1, 0, 0), b0(0, -1, 1), b1(0, 1, 1);
	const Eigen::Vector3d down(0, 0, -2), sideways(4, 0, 0);

	std::vector<std::string> methods = {"tight_inclusion"};
#ifdef IPC_TOOLKIT_WITH_EXACT_CCD
	methods.push_back("exact");
#endif
	for (const auto &method : methods)
	{
		const auto narrow_phase = make_narrow_phase(method, 1e-6, 1000000);
		double toi = std::numeric_limits<double>::infinity();
		CHECK(narrow_phase->edge_edge_ccd(a0, a1, b0, b1, a0, a1, b0 + down, b1 + down, toi));
		CHECK(toi > 0.3);
		CHECK(toi <= 0.5);
		CHECK_FALSE(narrow_phase->edge_edge_ccd(a0, a1, b0, b1, a0, a1, b0 + sideways, b1 + sideways, toi));
	}
}

TEST_CASE("a narrow phase without its name", "[contact][ccd]")
{
	CHECK_THROWS(make_narrow_phase("tight-inclusion", 1e-6, 1000000));
#ifndef IPC_TOOLKIT_WITH_EXACT_CCD
	CHECK_THROWS(make_narrow_phase("exact", 1e-6, 1000000));
#endif
}
