// The steps of `scenes` in the published data: the contacts among the published pairs are the true ones,
// with their times, bit for bit; the certified step ends before the first.

#include <cstring>
#include <optional>

#include <exact_ccd.hpp>

#include "check.h"
#include "ply.hpp"
#include "times.hpp"

namespace {

using exact_ccd::Kind;
namespace fs = std::filesystem;

struct Pair {
    Kind kind;
    std::uint32_t first, second;

    bool operator<(const Pair& other) const
    {
        return std::tie(kind, first, second) < std::tie(other.kind, other.first, other.second);
    }
};

// The first time, where it is published.
using Verdict = std::optional<std::optional<Time>>;

std::string text(const fs::path& file)
{
    std::ifstream input(file, std::ios::binary);
    CHECK(input);
    std::ostringstream text;
    text << input.rdbuf();
    return text.str();
}

// The pairs of a file of boxes, whose ids count the vertices, then the edges, then the faces.
std::vector<Pair> read_pairs(const fs::path& file, Kind kind, std::uint32_t vertices, std::uint32_t edges)
{
    const std::string numbers = text(file);
    const std::uint32_t offset = kind == Kind::edge_edge ? vertices : vertices + edges;
    std::vector<std::uint32_t> ids;
    for (const char* place = numbers.c_str(); *place != '\0'; ++place) {
        if (*place >= '0' && *place <= '9') {
            char* end = nullptr;
            ids.push_back(static_cast<std::uint32_t>(std::strtoul(place, &end, 10)));
            place = end - 1;
        }
    }
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i + 1 < ids.size(); i += 2) {
        if (kind == Kind::vertex_face) {
            pairs.push_back({kind, ids[i], ids[i + 1] - offset});
        } else {
            const auto [a, b] = std::minmax({ids[i] - offset, ids[i + 1] - offset});
            pairs.push_back({kind, a, b});
        }
    }
    return pairs;
}

// True for each pair that collides.
std::vector<bool> read_verdicts(const fs::path& file)
{
    const std::string words = text(file);
    std::vector<bool> verdicts;
    for (const char* place = words.c_str(); *place != '\0'; ++place) {
        if (std::strncmp(place, "true", 4) == 0 || std::strncmp(place, "false", 5) == 0) {
            verdicts.push_back(*place == 't');
        }
    }
    return verdicts;
}

fs::path only(const fs::path& folder, const std::string& end)
{
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0) {
            return entry.path();
        }
    }
    std::fprintf(stderr, "%s has no file that ends in %s\n", folder.c_str(), end.c_str());
    std::exit(1);
}

// The published pairs; for those in contact, the first time if it is published.
std::map<Pair, Verdict> read_truth(const fs::path& scene, std::uint32_t vertices, std::uint32_t edges)
{
    std::map<Pair, Verdict> truth;
    for (const auto& [name, kind] : {std::pair("vf", Kind::vertex_face), std::pair("ee", Kind::edge_edge)}) {
        const std::string file = name;
        const auto pairs = read_pairs(only(scene / "boxes", file + ".json"), kind, vertices, edges);
        const auto verdicts = read_verdicts(only(scene / "mma_bool", file + "_mma_bool.json"));
        CHECK(pairs.size() == verdicts.size() && !pairs.empty());
        std::map<std::size_t, Time> times;
        if (fs::exists(scene / "roots")) {
            times = read_times(scene / "roots" / (file + ".csv"));
        }
        for (std::size_t query = 0; query < pairs.size(); ++query) {
            Verdict verdict;
            if (verdicts[query]) {
                const auto time = times.find(query);
                CHECK(times.empty() || time != times.end());
                verdict = Verdict(std::in_place,
                                  time == times.end() ? std::nullopt : std::optional(time->second));
            }
            truth[pairs[query]] = verdict;
        }
    }
    return truth;
}

void compare(const fs::path& scene)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(scene / "frames")) {
        files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    CHECK(files.size() == 2);
    const Ply start = PlyReader(files[0]).read(), end = PlyReader(files[1]).read();
    const exact_ccd::Mesh mesh(start.positions.size(), start.faces);
    const auto truth = read_truth(scene,
                                  static_cast<std::uint32_t>(start.positions.size()),
                                  static_cast<std::uint32_t>(mesh.edges().size()));

    exact_ccd::Detector detector(mesh);
    const auto contacts = detector.collisions(start.positions, end.positions);
    std::size_t published = 0;
    for (const auto& contact : contacts) {
        const auto place = truth.find({static_cast<Kind>(contact.kind), contact.first, contact.second});
        if (place == truth.end()) {
            continue;
        }
        ++published;
        CHECK(place->second.has_value());
        if (const auto& time = *place->second) {
            CHECK(contact.impact.time == time->value && contact.impact.time_is_exact == time->is_exact);
        }
    }
    std::size_t expected = 0;
    for (const auto& [pair, verdict] : truth) {
        expected += verdict.has_value();
    }
    if (published != expected) {
        std::fprintf(stderr,
                     "%s: %zu of the %zu published contacts found\n",
                     scene.filename().c_str(),
                     published,
                     expected);
        std::exit(1);
    }

    const auto earliest = detector.collision(start.positions, end.positions);
    CHECK(earliest && earliest->impact.time == contacts.front().impact.time);
    const auto step = detector.free_step(start.positions, end.positions);
    CHECK(step.size > 0 && step.size <= 0.9 * earliest->impact.time);
    CHECK(!detector.collides(start.positions, step.positions));
    CHECK(detector.collides(start.positions, end.positions));
    std::printf("%s: %zu contacts, %zu of them among %zu published pairs, first at %.17g\n",
                scene.filename().c_str(),
                contacts.size(),
                published,
                truth.size(),
                earliest->impact.time);
}

}  // namespace

int main(int count_of_arguments, char** arguments)
{
    const char* data = std::getenv("EXACT_CCD_DATA");
    if (!data && count_of_arguments > 1) {
        data = arguments[1];
    }
    const fs::path folder = fs::path(data ? data : "") / "scenes";
    if (!fs::exists(folder)) {
        std::printf("skipped: there is no folder %s; set EXACT_CCD_DATA\n", folder.string().c_str());
        return 77;
    }
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        compare(entry.path());
        ++count;
    }
    CHECK(count == 3);
    return 0;
}
