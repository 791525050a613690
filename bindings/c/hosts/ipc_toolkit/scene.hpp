// The two frames of a scene as matrices of the IPC Toolkit.

#ifndef EXACT_CCD_HOSTS_SCENE_HPP
#define EXACT_CCD_HOSTS_SCENE_HPP

#include <Eigen/Core>

#include <exact_ccd.hpp>

#include "ply.hpp"

struct Scene {
    Eigen::MatrixXd x0, x1;
    Eigen::MatrixXi edges, faces;
};

template <typename Matrix, typename Rows>
Matrix matrix(const Rows& rows)
{
    Matrix matrix(rows.size(), rows[0].size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t j = 0; j < rows[i].size(); ++j) {
            matrix(i, j) = static_cast<typename Matrix::Scalar>(rows[i][j]);
        }
    }
    return matrix;
}

inline Scene read_scene(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "frames")) {
        files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    const Ply start = PlyReader(files.at(0)).read(), end = PlyReader(files.at(1)).read();
    const exact_ccd::Mesh mesh(start.positions.size(), start.faces);
    return {matrix<Eigen::MatrixXd>(start.positions),
            matrix<Eigen::MatrixXd>(end.positions),
            matrix<Eigen::MatrixXi>(mesh.edges()),
            matrix<Eigen::MatrixXi>(start.faces)};
}

#endif
