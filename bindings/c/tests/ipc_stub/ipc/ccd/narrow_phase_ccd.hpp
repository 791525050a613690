// The interface of the IPC Toolkit that exact_ccd/ipc_toolkit.hpp uses, without the toolkit: version 1.6, or
// with IPC_BEFORE_1_6 versions 1.4 and 1.5.

#pragma once

#include <Eigen/Core>

namespace Eigen {

template <typename T>
using ConstRef = const Ref<const T>&;

}

namespace ipc {

using VectorMax3d = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3, 1>;

class NarrowPhaseCCD {
public:
    using Small = Eigen::ConstRef<VectorMax3d>;
    using Vector = Eigen::ConstRef<Eigen::Vector3d>;

    virtual ~NarrowPhaseCCD() = default;

    virtual bool point_point_ccd(Small,
                                 Small,
                                 Small,
                                 Small,
                                 double& toi,
                                 const double min_distance = 0.0,
                                 const double tmax = 1.0) const = 0;
    virtual bool point_edge_ccd(Small,
                                Small,
                                Small,
                                Small,
                                Small,
                                Small,
                                double& toi,
                                const double min_distance = 0.0,
                                const double tmax = 1.0) const = 0;
    virtual bool point_triangle_ccd(Vector,
                                    Vector,
                                    Vector,
                                    Vector,
                                    Vector,
                                    Vector,
                                    Vector,
                                    Vector,
                                    double& toi,
                                    const double min_distance = 0.0,
                                    const double tmax = 1.0) const = 0;
    virtual bool edge_edge_ccd(Vector,
                               Vector,
                               Vector,
                               Vector,
                               Vector,
                               Vector,
                               Vector,
                               Vector,
                               double& toi,
                               const double min_distance = 0.0,
                               const double tmax = 1.0) const = 0;

#ifndef IPC_BEFORE_1_6
    double conservative_rescaling;
#endif
};

}  // namespace ipc
