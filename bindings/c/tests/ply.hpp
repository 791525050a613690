// A reader of binary PLY files that have vertices x y z, float or double, then triangles: the frames of
// the scenes.

#ifndef EXACT_CCD_TESTS_PLY_HPP
#define EXACT_CCD_TESTS_PLY_HPP

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

struct Ply {
    std::vector<std::array<double, 3>> positions;
    std::vector<std::array<std::uint32_t, 3>> faces;
};

class PlyReader {
public:
    explicit PlyReader(const std::filesystem::path& file) : input_(file, std::ios::binary) {}

    Ply read()
    {
        std::size_t vertex_count = 0, face_count = 0;
        bool is_float = false;
        std::string line, word, name;
        while (std::getline(input_, line) && line != "end_header") {
            std::istringstream words(line);
            words >> word >> name;
            if (word == "format") {
                is_big_endian_ = name == "binary_big_endian";
            } else if (word == "element") {
                words >> (name == "vertex" ? vertex_count : face_count);
            } else if (word == "property") {
                is_float = is_float || name == "float";
            }
        }
        Ply ply{std::vector<std::array<double, 3>>(vertex_count),
                std::vector<std::array<std::uint32_t, 3>>(face_count)};
        for (auto& position : ply.positions) {
            for (double& x : position) {
                x = is_float ? number<float>() : number<double>();
            }
        }
        for (auto& face : ply.faces) {
            if (number<std::uint8_t>() != 3) {
                throw std::runtime_error("a face is no triangle");
            }
            for (std::uint32_t& vertex : face) {
                vertex = number<std::uint32_t>();
            }
        }
        if (!input_ || ply.positions.empty()) {
            throw std::runtime_error("the PLY file is missing or ends early");
        }
        return ply;
    }

private:
    // Of a little-endian machine.
    template <typename Number>
    Number number()
    {
        std::array<char, sizeof(Number)> bytes{};
        input_.read(bytes.data(), bytes.size());
        if (is_big_endian_) {
            std::reverse(bytes.begin(), bytes.end());
        }
        Number value;
        std::memcpy(&value, bytes.data(), sizeof value);
        return value;
    }

    std::ifstream input_;
    bool is_big_endian_ = false;
};

#endif
