// The published times of queries: a row for each one in contact.

#ifndef EXACT_CCD_TESTS_TIMES_HPP
#define EXACT_CCD_TESTS_TIMES_HPP

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "check.h"

struct Time {
    // The number of intervals, or of contact times.
    std::size_t count = 0;
    // The first time.
    double value = NAN;
    bool is_exact = false;
};

// By the number of the query.
inline std::map<std::size_t, Time> read_times(const std::filesystem::path& file)
{
    std::ifstream input(file);
    CHECK(input);
    std::map<std::size_t, Time> times;
    std::string line;
    std::getline(input, line);
    while (std::getline(input, line)) {
        std::istringstream row(line);
        std::size_t query = 0;
        char comma = 0;
        std::string time;
        Time answer;
        row >> query >> comma >> answer.count >> comma;
        std::getline(row, time, ',');
        answer.value = std::strtod(time.c_str(), nullptr);
        row >> answer.is_exact;
        CHECK(row);
        times[query] = answer;
    }
    return times;
}

#endif
