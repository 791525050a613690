// All queries of `separation` in the published data, with their truth: verdict, number of intervals, first time
// and its exactness, bit for bit, query by query and as batches.

#include <exact_ccd.hpp>

#include "check.h"
#include "times.hpp"

namespace {

using exact_ccd::Kind;
using exact_ccd::Point;

// A coordinate, which is a double, as numerator and denominator: two integers in the range of long double.
double coordinate(std::istream& line)
{
    static_assert(sizeof(long double) > sizeof(double), "needs the range of extended precision");
    std::string numerator, denominator;
    CHECK(std::getline(line, numerator, ',') && std::getline(line, denominator, ','));
    return static_cast<double>(std::strtold(numerator.c_str(), nullptr)
                               / std::strtold(denominator.c_str(), nullptr));
}

// The queries of a file; returns their number.
std::size_t compare(const std::filesystem::path& file, Kind kind, double min_distance)
{
    const std::size_t n = exact_ccd::point_count(kind);
    std::ifstream input(file);
    CHECK(input);
    std::vector<Point> x0, x1;
    std::string line;
    for (std::size_t row = 0; std::getline(input, line); ++row) {
        std::istringstream columns(line);
        Point point;
        for (double& x : point) {
            x = coordinate(columns);
        }
        (row / n % 2 == 0 ? x0 : x1).push_back(point);
    }
    CHECK(x0.size() == x1.size() && x0.size() % n == 0 && !x0.empty());

    auto times_name = file;
    const auto published = read_times(times_name.replace_extension(".times.csv"));
    std::vector<std::uint32_t> vertices(x0.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        vertices[i] = static_cast<std::uint32_t>(i);
    }
    const auto times = exact_ccd::times_of_impact(kind, x0, x1, vertices, min_distance);

    for (std::size_t query = 0; query < times.size(); ++query) {
        const exact_ccd::Points t0(x0[n * query].data(), n), t1(x1[n * query].data(), n);
        const auto expected = published.find(query);
        const bool is_hit = expected != published.end();
        CHECK(exact_ccd::collides(kind, t0, t1, min_distance) == is_hit);
        const auto impact = exact_ccd::impact(kind, t0, t1, min_distance);
        CHECK(impact.has_value() == is_hit && std::isnan(times[query]) != is_hit);
        const auto intervals = exact_ccd::intervals(kind, t0, t1, min_distance);
        if (!is_hit) {
            CHECK(intervals.empty());
            continue;
        }
        const Time& answer = expected->second;
        CHECK(impact->time == answer.value && impact->time_is_exact == answer.is_exact);
        CHECK(times[query] == answer.value);
        CHECK(intervals.size() == answer.count && intervals.front().start == answer.value);
    }
    return times.size();
}

}  // namespace

int main(int count_of_arguments, char** arguments)
{
    const char* data = std::getenv("EXACT_CCD_DATA");
    if (!data && count_of_arguments > 1) {
        data = arguments[1];
    }
    const std::filesystem::path folder = std::filesystem::path(data ? data : "") / "separation";
    if (!std::filesystem::exists(folder)) {
        std::printf("skipped: there is no folder %s; set EXACT_CCD_DATA\n", folder.string().c_str());
        return 77;
    }
    const std::map<std::string, Kind> kinds{{"vf", Kind::vertex_face},
                                            {"ee", Kind::edge_edge},
                                            {"ve", Kind::vertex_edge},
                                            {"vv", Kind::vertex_vertex}};
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        const std::string suffix = ".times.csv";
        if (name.size() > suffix.size() && name.substr(name.size() - suffix.size()) == suffix) {
            continue;
        }
        // KIND-FAMILY-dDISTANCE.csv
        const double min_distance = std::strtod(name.c_str() + name.rfind("-d") + 2, nullptr);
        count += compare(entry.path(), kinds.at(name.substr(0, 2)), min_distance);
    }
    std::printf("%zu queries agree with the truth\n", count);
    CHECK(count > 1000);
    return 0;
}
