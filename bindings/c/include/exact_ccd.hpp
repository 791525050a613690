// The C++17 interface of exact-ccd: the functions of exact_ccd.h with exceptions, RAII and
// std::optional. Header only.
//
// Points are passed as views of contiguous doubles, three for each point: std::vector and std::array of
// double[3], of std::array<double, 3> or of a struct that is declared to be three doubles
// (exact_ccd::is_element); row-major Eigen matrices of three columns, and maps of such; and a pointer with a
// number of points. Nothing is copied.

#ifndef EXACT_CCD_HPP
#define EXACT_CCD_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "exact_ccd.h"

namespace exact_ccd {

/// A call that failed: `what()` names the argument, the vertex or the query that is wrong.
class Error : public std::runtime_error {
public:
    explicit Error(const exact_ccd_error_t& error)
        : std::runtime_error(error.message),
          status_(error.status),
          query_(error.has_query ? std::optional(error.query) : std::nullopt),
          edge_(error.edge),
          face_(error.face)
    {}

    exact_ccd_status_t status() const noexcept { return status_; }

    /// The index, from 0, of the first query of a batch that is wrong.
    std::optional<std::size_t> query() const noexcept { return query_; }

    /// The edge and the face that cross at the start, for EXACT_CCD_STATUS_CROSSING; else EXACT_CCD_NONE.
    std::uint32_t edge() const noexcept { return edge_; }
    std::uint32_t face() const noexcept { return face_; }

private:
    exact_ccd_status_t status_;
    std::optional<std::size_t> query_;
    std::uint32_t edge_, face_;
};

/// Throws the error of a call that failed.
inline void check(exact_ccd_status_t status)
{
    if (status != EXACT_CCD_STATUS_OK) {
        throw Error(exact_ccd_last_error_fields());
    }
}

enum class Kind : std::uint32_t {
    vertex_face = EXACT_CCD_KIND_VERTEX_FACE,
    edge_edge = EXACT_CCD_KIND_EDGE_EDGE,
    vertex_edge = EXACT_CCD_KIND_VERTEX_EDGE,
    vertex_vertex = EXACT_CCD_KIND_VERTEX_VERTEX,
    /// An intersection at rest, which is no query.
    edge_face = EXACT_CCD_KIND_EDGE_FACE,
};

/// The number of points of both primitives.
constexpr std::size_t point_count(Kind kind)
{
    return kind == Kind::edge_face ? 5 : kind == Kind::vertex_vertex ? 2 : kind == Kind::vertex_edge ? 3 : 4;
}

using Point = std::array<double, 3>;
using Impact = exact_ccd_impact_t;
using Interval = exact_ccd_interval_t;
using Contact = exact_ccd_contact_t;
using Pair = exact_ccd_pair_t;

/// True for the types that are `N` numbers `T` in memory. For other structs than these arrays, specialise it:
///
///   template <>
///   struct exact_ccd::is_element<Vector, double, 3> : std::true_type {};
template <typename Element, typename T, std::size_t N>
struct is_element : std::bool_constant<std::is_same_v<Element, T[N]> || std::is_same_v<Element, std::array<T, N>>
                                       || (N == 1 && std::is_same_v<Element, T>)> {};

namespace detail {

template <typename Container>
using Element = std::remove_cv_t<std::remove_pointer_t<decltype(std::declval<const Container&>().data())>>;

template <typename Container, typename = void>
struct is_matrix : std::false_type {};

// Matrices of Eigen have this member. Rows are elements, and vectors are arrays of numbers.
template <typename Container>
struct is_matrix<Container, std::void_t<decltype(Container::ColsAtCompileTime)>> : std::true_type {};

}  // namespace detail

/// A view of `size` elements of `N` numbers each.
template <typename T, std::size_t N>
class View {
public:
    View() = default;
    View(const T* data, std::size_t size) : data_(data), size_(size) {}

    /// A contiguous container of elements of `N` numbers `T`.
    template <typename Container,
              typename Element = detail::Element<Container>,
              std::enable_if_t<is_element<Element, T, N>::value && !detail::is_matrix<Container>::value, int> = 0>
    View(const Container& container)
        : data_(reinterpret_cast<const T*>(container.data())), size_(container.size())
    {
        static_assert(sizeof(Element) == N * sizeof(T) && std::is_standard_layout_v<Element>,
                      "an element consists of N numbers");
    }

    /// A row-major matrix of `N` columns, or a vector of numbers, without gaps.
    template <typename Matrix, std::enable_if_t<detail::is_matrix<Matrix>::value, long> = 0>
    View(const Matrix& matrix)
        : data_(matrix.data()), size_(static_cast<std::size_t>(matrix.size()) / N)
    {
        static_assert(std::is_same_v<detail::Element<Matrix>, T>,
                      "exact_ccd: positions are matrices of double, indices matrices of std::uint32_t: "
                      "call cast<double>() or cast<std::uint32_t>(), and eval()");
        static_assert(N == 1 ? static_cast<bool>(Matrix::IsVectorAtCompileTime)
                             : Matrix::ColsAtCompileTime == static_cast<int>(N),
                      "exact_ccd: positions and faces have 3 columns and edges 2, known at compile time; "
                      "other arguments are vectors");
        static_assert(N == 1 || static_cast<bool>(Matrix::IsRowMajor),
                      "exact_ccd: the matrix is not row-major: declare it, for positions, as "
                      "Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>");
        const bool is_contiguous = matrix.innerStride() == 1
                                   && (N == 1 || matrix.rows() < 2 || matrix.outerStride() == matrix.cols());
        if (!is_contiguous) {
            throw std::invalid_argument("exact_ccd: a matrix has gaps between its numbers: copy it");
        }
    }

    const T* data() const noexcept { return data_; }
    std::size_t size() const noexcept { return size_; }

private:
    const T* data_ = nullptr;
    std::size_t size_ = 0;
};

using Points = View<double, 3>;
using Faces = View<std::uint32_t, 3>;
using Edges = View<std::uint32_t, 2>;

namespace detail {

inline void check_points(Kind kind, Points t0, Points t1)
{
    if (t0.size() != point_count(kind) || t1.size() != point_count(kind)) {
        throw std::invalid_argument("exact_ccd: " + std::to_string(t0.size()) + " points at t = 0 and "
                                    + std::to_string(t1.size()) + " at t = 1, expected "
                                    + std::to_string(point_count(kind)));
    }
}

inline void check_counts(Points x0, Points x1)
{
    if (x0.size() != x1.size()) {
        throw std::invalid_argument("exact_ccd: " + std::to_string(x1.size())
                                    + " positions at t = 1, expected as many as at t = 0: "
                                    + std::to_string(x0.size()));
    }
}

inline std::size_t query_count(Kind kind, View<std::uint32_t, 1> indices)
{
    if (indices.size() % point_count(kind) != 0) {
        throw std::invalid_argument("exact_ccd: the number of indices is no multiple of "
                                    + std::to_string(point_count(kind)));
    }
    return indices.size() / point_count(kind);
}

/// An object of the library, and its owner.
template <typename T, void (*free)(T*)>
struct Free {
    void operator()(T* object) const noexcept { free(object); }
};
template <typename T, void (*free)(T*)>
using Handle = std::unique_ptr<T, Free<T, free>>;

/// The elements of a list of the library, which is freed.
template <typename Element, typename List>
std::vector<Element> copy(List* list,
                          exact_ccd_status_t (*elements)(const List*, const Element**, std::size_t*),
                          void (*free)(List*))
{
    const std::unique_ptr<List, void (*)(List*)> owner(list, free);
    const Element* data = nullptr;
    std::size_t count = 0;
    check(elements(list, &data, &count));
    return std::vector<Element>(data, data + count);
}

}  // namespace detail

/// Decides if two primitives touch: if they come within the distance `separation`, or are in contact if it is 0.
/// `until` is the last time that counts; the exact time is compared.
inline bool collides(Kind kind, Points x0, Points x1, double separation = 0, double until = 1)
{
    detail::check_points(kind, x0, x1);
    bool answer = false;
    check(exact_ccd_collides(
        static_cast<std::uint32_t>(kind), x0.data(), x1.data(), separation, until, &answer));
    return answer;
}

/// The first time at which the primitives touch, rounded down; none if they do not collide.
inline std::optional<double> time_of_impact(
    Kind kind, Points x0, Points x1, double separation = 0, double until = 1)
{
    detail::check_points(kind, x0, x1);
    double time = 0;
    check(exact_ccd_time_of_impact(
        static_cast<std::uint32_t>(kind), x0.data(), x1.data(), separation, until, &time));
    return std::isnan(time) ? std::nullopt : std::optional(time);
}

/// The first time at which the primitives touch, with the closest points and the normal then.
inline std::optional<Impact> impact(Kind kind, Points x0, Points x1, double separation = 0, double until = 1)
{
    detail::check_points(kind, x0, x1);
    bool is_found = false;
    Impact answer{};
    check(exact_ccd_impact(
        static_cast<std::uint32_t>(kind), x0.data(), x1.data(), separation, until, &is_found, &answer));
    return is_found ? std::optional(answer) : std::nullopt;
}

/// The times at which the primitives touch: the maximal closed intervals, in increasing order; none if the first
/// is after `until`.
inline std::vector<Interval> intervals(
    Kind kind, Points x0, Points x1, double separation = 0, double until = 1)
{
    detail::check_points(kind, x0, x1);
    std::vector<Interval> answer(32);
    std::size_t count = 0;
    check(exact_ccd_intervals(static_cast<std::uint32_t>(kind),
                              x0.data(),
                              x1.data(),
                              separation,
                              until,
                              answer.data(),
                              answer.size(),
                              &count));
    answer.resize(count);
    return answer;
}

/// Bounds of the distance at a time of the step: the nearest doubles not above and not below it.
inline std::pair<double, double> distance_at(Kind kind, Points x0, Points x1, double time)
{
    detail::check_points(kind, x0, x1);
    std::pair<double, double> bounds;
    check(exact_ccd_distance_at(
        static_cast<std::uint32_t>(kind), x0.data(), x1.data(), time, &bounds.first, &bounds.second));
    return bounds;
}

/// The first time of each of many queries about the same vertices, NaN for none. `indices` has the vertices
/// of each query, as many as the kind has points; `threads` is the number of threads, or 0 for the number in
/// `set_threads`.
inline std::vector<double> times_of_impact(Kind kind,
                                           Points x0,
                                           Points x1,
                                           View<std::uint32_t, 1> indices,
                                           double separation = 0,
                                           double until = 1,
                                           std::uint32_t threads = 0)
{
    detail::check_counts(x0, x1);
    std::vector<double> times(detail::query_count(kind, indices));
    check(exact_ccd_batch_time_of_impact(static_cast<std::uint32_t>(kind),
                                         x0.data(),
                                         x1.data(),
                                         x0.size(),
                                         indices.data(),
                                         times.size(),
                                         separation,
                                         until,
                                         threads,
                                         times.data()));
    return times;
}

/// `times_of_impact` for vertices of different thickness: the distance of a query is the sum of the largest
/// thickness of the vertices of each primitive, rounded up.
inline std::vector<double> times_of_impact_thick(Kind kind,
                                                 Points x0,
                                                 Points x1,
                                                 View<std::uint32_t, 1> indices,
                                                 View<double, 1> thickness,
                                                 double until = 1,
                                                 std::uint32_t threads = 0)
{
    detail::check_counts(x0, x1);
    if (thickness.size() != x0.size()) {
        throw std::invalid_argument("exact_ccd: " + std::to_string(thickness.size())
                                    + " thicknesses, expected one for each of "
                                    + std::to_string(x0.size()) + " vertices");
    }
    std::vector<double> times(detail::query_count(kind, indices));
    check(exact_ccd_batch_time_of_impact_thick(static_cast<std::uint32_t>(kind),
                                               x0.data(),
                                               x1.data(),
                                               x0.size(),
                                               indices.data(),
                                               times.size(),
                                               thickness.data(),
                                               until,
                                               threads,
                                               times.data()));
    return times;
}

/// Sets the number of threads of the batches, detectors and audits that have none of their own, 0 for the
/// number of cores.
inline void set_threads(std::uint32_t count) { check(exact_ccd_set_threads(count)); }

/// Throws if the loaded library has another binary interface than this header.
inline void check_version()
{
    if (exact_ccd_abi_version() != EXACT_CCD_ABI_VERSION) {
        throw std::runtime_error("exact_ccd: the library " + std::string(exact_ccd_version())
                                 + " has the binary interface " + std::to_string(exact_ccd_abi_version())
                                 + ", the header " + std::to_string(EXACT_CCD_ABI_VERSION));
    }
}

/// The connectivity of a mesh.
class Mesh {
public:
    Mesh(std::size_t vertex_count, Faces faces, Edges edges = {}) : vertex_count_(vertex_count)
    {
        exact_ccd_mesh_t* mesh = nullptr;
        check(exact_ccd_mesh_new(
            vertex_count, faces.data(), faces.size(), edges.data(), edges.size(), &mesh));
        handle_.reset(mesh);
    }

    std::size_t vertex_count() const noexcept { return vertex_count_; }

    /// The edges of the faces, then the edges of no face: contacts name edges by their index here.
    std::vector<std::array<std::uint32_t, 2>> edges() const
    {
        std::size_t face_count = 0, edge_count = 0, loose_edge_count = 0;
        check(exact_ccd_mesh_counts(handle(), &face_count, &edge_count, &loose_edge_count));
        std::vector<std::array<std::uint32_t, 2>> edges(edge_count);
        check(exact_ccd_mesh_edges(
            handle(), reinterpret_cast<std::uint32_t*>(edges.data()), edges.size()));
        return edges;
    }

    const exact_ccd_mesh_t* handle() const noexcept { return handle_.get(); }

private:
    detail::Handle<exact_ccd_mesh_t, exact_ccd_mesh_free> handle_;
    std::size_t vertex_count_;
};

/// The settings of a `Detector` and of `Worlds`.
class Searcher {
public:
    void set_min_distance(double min_distance)
    {
        check(exact_ccd_detector_set_min_distance(handle(), min_distance));
    }

    /// Pairs that start within `min_distance` are in contact only if they come within `inner_distance`, if that is
    /// smaller.
    void set_inner_distance(double min_distance, double inner_distance)
    {
        check(exact_ccd_detector_set_inner_distance(handle(), min_distance, inner_distance));
    }

    void set_thickness(View<double, 1> thickness)
    {
        check(exact_ccd_detector_set_thickness(handle(), thickness.data(), thickness.size()));
    }

    void set_groups(View<std::uint32_t, 1> groups)
    {
        check(exact_ccd_detector_set_groups(handle(), groups.data(), groups.size()));
    }

    /// The number of threads, or 0 for the number in `exact_ccd::set_threads`.
    void set_threads(std::uint32_t count) { check(exact_ccd_detector_set_threads(handle(), count)); }

    /// Only primitives can collide if `rule` allows two of their vertices: a function object with a call
    /// `bool(std::uint32_t, std::uint32_t)`, which the detector owns. It is called from several threads, and
    /// ends the program if it throws.
    template <typename Rule,
              std::enable_if_t<std::is_invocable_r_v<bool, Rule&, std::uint32_t, std::uint32_t>, int> = 0>
    void set_can_collide(Rule rule)
    {
        auto data = std::make_unique<Rule>(std::move(rule));
        check(exact_ccd_detector_set_can_collide_owned(
            handle(),
            [](std::uint32_t a, std::uint32_t b, void* rule) noexcept -> bool {
                return (*static_cast<Rule*>(rule))(a, b);
            },
            data.get(),
            [](void* rule) noexcept { delete static_cast<Rule*>(rule); }));
        data.release();
    }

    /// The callback and its data are used until another rule replaces them, from several threads.
    void set_can_collide(exact_ccd_can_collide_t can_collide, void* data)
    {
        check(exact_ccd_detector_set_can_collide(handle(), can_collide, data));
    }

    /// As `set_can_collide`, for a callback that decides about whole primitives.
    void set_pair_can_collide(exact_ccd_pair_can_collide_t can_collide, void* data)
    {
        check(exact_ccd_detector_set_pair_can_collide(handle(), can_collide, data));
    }

    /// With the check of the start, an answer about a step throws an Error with EXACT_CCD_STATUS_CROSSING if an
    /// edge passes through a face at `x0`. Without it, which is the default, such a mesh may be free of contact.
    void set_start_check(bool is_on) { check(exact_ccd_detector_set_start_check(handle(), is_on)); }

    exact_ccd_detector_t* handle() const noexcept { return handle_.get(); }

protected:
    explicit Searcher(const Mesh& mesh)
    {
        exact_ccd_detector_t* detector = nullptr;
        check(exact_ccd_detector_new(mesh.handle(), &detector));
        handle_.reset(detector);
    }

private:
    detail::Handle<exact_ccd_detector_t, exact_ccd_detector_free> handle_;
};

/// Contact in successive steps of one mesh. Not for several threads at the same time.
class Detector : public Searcher {
public:
    /// A step that is certified to be free of contact.
    struct FreeStep {
        double size;
        std::vector<Point> positions;
        /// The earliest contact of the full step; none if the full step is free.
        std::optional<Contact> contact;
    };

    /// A step for every vertex, certified to be free of contact but for the pairs `blocked`.
    struct FreeSteps {
        std::vector<double> sizes;
        std::vector<Point> positions;
        /// The number of searches for contact.
        std::size_t rounds;
        std::vector<Pair> blocked;
    };

    /// The contacts of a step, the earliest first. For each vertex, the index of the first one of a pair to which
    /// it belongs, and its time; the number of contacts, and infinity, for a vertex without contact.
    struct FirstContacts {
        std::vector<Contact> contacts;
        std::vector<std::size_t> first;
        std::vector<double> times;
    };

    /// An edge and a face, by their indices, that meet at rest.
    struct Intersection {
        std::uint32_t edge, face;
    };

    explicit Detector(const Mesh& mesh) : Searcher(mesh) {}

    /// The first edge and face that can collide, have no common vertex and meet at rest.
    std::optional<Intersection> intersection(Points x) const
    {
        bool is_found = false;
        Intersection found{};
        check(exact_ccd_detector_has_intersections(
            handle(), x.data(), x.size(), &is_found, &found.edge, &found.face));
        return is_found ? std::optional(found) : std::nullopt;
    }

    /// True if an edge and a face that can collide and have no common vertex meet at rest.
    bool has_intersections(Points x) const
    {
        bool answer = false;
        check(exact_ccd_detector_has_intersections(handle(), x.data(), x.size(), &answer, nullptr, nullptr));
        return answer;
    }

    /// True if any two primitives touch. `until`, from 0 to 1, is the last time that counts; the exact time is
    /// compared. A mesh that is pierced at `x0` may be free of contact: see `set_start_check`, and docs/pairs.md
    /// for the pairs that are compared.
    bool collides(Points x0, Points x1, double until = 1)
    {
        detail::check_counts(x0, x1);
        bool answer = false;
        check(exact_ccd_detector_collides(handle(), x0.data(), x1.data(), x0.size(), until, &answer));
        return answer;
    }

    /// The earliest contact; none if the primitives do not collide.
    std::optional<Contact> collision(Points x0, Points x1, double until = 1)
    {
        detail::check_counts(x0, x1);
        bool is_found = false;
        Contact contact{};
        check(exact_ccd_detector_collision(
            handle(), x0.data(), x1.data(), x0.size(), until, &is_found, &contact));
        return is_found ? std::optional(contact) : std::nullopt;
    }

    /// All contacts, the earliest first.
    std::vector<Contact> collisions(Points x0, Points x1, double until = 1)
    {
        detail::check_counts(x0, x1);
        exact_ccd_contacts_t* contacts = nullptr;
        check(exact_ccd_detector_collisions(
            handle(), x0.data(), x1.data(), x0.size(), until, &contacts));
        return detail::copy<Contact>(contacts, exact_ccd_contacts_data, exact_ccd_contacts_free);
    }

    /// The size of a step without contact, at most `keep` times the time of impact, and the certified
    /// positions at its end. The size is 0 if none of the sizes that are tried is certified. A mesh that is pierced at `x0` may be
    /// free of contact, with size 1: see `set_start_check`, and docs/pairs.md for the pairs that are compared.
    FreeStep free_step(Points x0, Points x1, double keep = 0.9)
    {
        detail::check_counts(x0, x1);
        FreeStep step{0, std::vector<Point>(x0.size()), std::nullopt};
        bool is_found = false;
        Contact contact{};
        check(exact_ccd_detector_free_step(handle(),
                                           x0.data(),
                                           x1.data(),
                                           x0.size(),
                                           keep,
                                           &step.size,
                                           reinterpret_cast<double*>(step.positions.data()),
                                           &is_found,
                                           &contact));
        if (is_found) {
            step.contact = contact;
        }
        return step;
    }

    /// A size for each vertex, such that the motion of all vertices to the positions is certified to be free of
    /// contact, but for the pairs `blocked`. The vertices `pinned` go all the way. docs/steps.md has the rule.
    FreeSteps free_steps(Points x0, Points x1, View<std::uint32_t, 1> pinned = {}, double keep = 0.9)
    {
        detail::check_counts(x0, x1);
        FreeSteps steps{std::vector<double>(x0.size()), std::vector<Point>(x0.size()), 0, {}};
        exact_ccd_pairs_t* blocked = nullptr;
        check(exact_ccd_detector_free_steps(handle(),
                                            x0.data(),
                                            x1.data(),
                                            x0.size(),
                                            pinned.data(),
                                            pinned.size(),
                                            keep,
                                            steps.sizes.data(),
                                            reinterpret_cast<double*>(steps.positions.data()),
                                            &steps.rounds,
                                            &blocked));
        steps.blocked = detail::copy<Pair>(blocked, exact_ccd_pairs_data, exact_ccd_pairs_free);
        return steps;
    }

    /// The proof of the answer to a step, with `at_rest` also that no edge passes through a face at `x0`: the bytes
    /// of a file that the program exact-ccd-check verifies (docs/certificates.md). Throws an Error with
    /// EXACT_CCD_STATUS_UNCERTIFIED if some pairs have no proof.
    std::vector<std::uint8_t> certificate(Points x0, Points x1, bool at_rest = true)
    {
        detail::check_counts(x0, x1);
        exact_ccd_certificate_t* certificate = nullptr;
        check(exact_ccd_detector_certificate(
            handle(), x0.data(), x1.data(), x0.size(), at_rest, &certificate));
        return detail::copy<std::uint8_t>(certificate, exact_ccd_certificate_data, exact_ccd_certificate_free);
    }

    /// All contacts, the earliest first, and the first one of each vertex, for rules of your own.
    FirstContacts first_contacts(Points x0, Points x1, double until = 1)
    {
        detail::check_counts(x0, x1);
        FirstContacts all{{}, std::vector<std::size_t>(x0.size()), std::vector<double>(x0.size())};
        exact_ccd_contacts_t* contacts = nullptr;
        check(exact_ccd_detector_first_contacts(handle(),
                                                x0.data(),
                                                x1.data(),
                                                x0.size(),
                                                until,
                                                all.first.data(),
                                                all.times.data(),
                                                &contacts));
        all.contacts = detail::copy<Contact>(contacts, exact_ccd_contacts_data, exact_ccd_contacts_free);
        return all;
    }

    /// The clearance of each vertex at rest: the least distance of a pair to which it belongs, rounded down, or
    /// `cut_off` if all are farther apart. Displacements below half of the clearances are free of contact.
    std::vector<double> clearances(Points x, double cut_off)
    {
        std::vector<double> clearances(x.size());
        check(exact_ccd_detector_clearances(handle(), x.data(), x.size(), cut_off, clearances.data()));
        return clearances;
    }
};

/// Contact in steps of many worlds, which have one mesh. `x0` and `x1` have the positions of the first
/// world, then of the next one, and so on. Each world gets the answers that a `Detector` gives. The worlds
/// are decided in parallel. The methods that are `const` may be called by several threads at the same time.
class Worlds : public Searcher {
public:
    /// Steps that are certified to be free of contact, of all worlds.
    struct FreeSteps {
        std::vector<double> sizes;
        std::vector<Point> positions;
        /// The earliest contact of each full step; none if it is free.
        std::vector<std::optional<Contact>> contacts;
    };

    explicit Worlds(const Mesh& mesh) : Searcher(mesh), vertex_count_(mesh.vertex_count()) {}

    /// As `Detector::collides`, for each world.
    std::vector<bool> collides(Points x0, Points x1, double until = 1) const
    {
        const std::size_t count = world_count(x0, x1);
        const auto answers = std::make_unique<bool[]>(count);
        check(exact_ccd_worlds_collides(
            handle(), x0.data(), x1.data(), vertex_count_, count, until, answers.get()));
        return std::vector<bool>(answers.get(), answers.get() + count);
    }

    /// The earliest contact of each world; none if its primitives do not collide.
    std::vector<std::optional<Contact>> collision(Points x0, Points x1, double until = 1) const
    {
        const std::size_t count = world_count(x0, x1);
        const auto is_found = std::make_unique<bool[]>(count);
        std::vector<Contact> contacts(count);
        check(exact_ccd_worlds_collision(
            handle(), x0.data(), x1.data(), vertex_count_, count, until, is_found.get(), contacts.data()));
        return found(is_found.get(), contacts);
    }

    /// All contacts of each world, the earliest first.
    std::vector<std::vector<Contact>> collisions(Points x0, Points x1, double until = 1) const
    {
        std::vector<std::size_t> counts(world_count(x0, x1));
        exact_ccd_contacts_t* list = nullptr;
        check(exact_ccd_worlds_collisions(
            handle(), x0.data(), x1.data(), vertex_count_, counts.size(), until, counts.data(), &list));
        const auto all = detail::copy<Contact>(list, exact_ccd_contacts_data, exact_ccd_contacts_free);
        std::vector<std::vector<Contact>> contacts;
        const Contact* first = all.data();
        for (const std::size_t count : counts) {
            contacts.emplace_back(first, first + count);
            first += count;
        }
        return contacts;
    }

    /// As `Detector::free_step`, with a size for each world.
    FreeSteps free_step(Points x0, Points x1, double keep = 0.9) const
    {
        const std::size_t count = world_count(x0, x1);
        FreeSteps steps{std::vector<double>(count), std::vector<Point>(x0.size()), {}};
        const auto is_found = std::make_unique<bool[]>(count);
        std::vector<Contact> contacts(count);
        check(exact_ccd_worlds_free_step(handle(),
                                         x0.data(),
                                         x1.data(),
                                         vertex_count_,
                                         count,
                                         keep,
                                         steps.sizes.data(),
                                         reinterpret_cast<double*>(steps.positions.data()),
                                         is_found.get(),
                                         contacts.data()));
        steps.contacts = found(is_found.get(), contacts);
        return steps;
    }

private:
    std::size_t world_count(Points x0, Points x1) const
    {
        detail::check_counts(x0, x1);
        const std::size_t count = x0.size() / std::max<std::size_t>(vertex_count_, 1);
        if (count * vertex_count_ != x0.size()) {
            throw std::invalid_argument("exact_ccd: " + std::to_string(x0.size())
                                        + " positions, expected a multiple of the number of vertices: "
                                        + std::to_string(vertex_count_));
        }
        return count;
    }

    static std::vector<std::optional<Contact>> found(const bool* is_found, const std::vector<Contact>& contacts)
    {
        std::vector<std::optional<Contact>> found(contacts.size());
        for (std::size_t world = 0; world < found.size(); ++world) {
            if (is_found[world]) {
                found[world] = contacts[world];
            }
        }
        return found;
    }

    std::size_t vertex_count_;
};

/// Examines the frames of a mesh one after the other.
class Audit {
public:
    struct Violation {
        exact_ccd_audit_result_t kind;
        Contact contact;
    };

    explicit Audit(const Mesh& mesh, double min_distance = 0)
    {
        exact_ccd_audit_t* audit = nullptr;
        check(exact_ccd_audit_new(mesh.handle(), min_distance, &audit));
        handle_.reset(audit);
    }

    /// The number of threads, or 0 for the number in `exact_ccd::set_threads`.
    void set_threads(std::uint32_t count) { check(exact_ccd_audit_set_threads(handle_.get(), count)); }

    /// Examines the next frame and the step that leads to it.
    std::optional<Violation> examine(Points x)
    {
        Violation violation{};
        check(exact_ccd_audit_examine(
            handle_.get(), x.data(), x.size(), &violation.kind, &violation.contact));
        return violation.kind == EXACT_CCD_AUDIT_RESULT_FREE ? std::nullopt : std::optional(violation);
    }

    /// Makes a certificate of all frames that follow; to be called before the first one.
    void certify() { check(exact_ccd_audit_certify(handle_.get())); }

    /// The proof of the results so far, after `certify`, as of `Detector::certificate`.
    std::vector<std::uint8_t> certificate() const
    {
        exact_ccd_certificate_t* certificate = nullptr;
        check(exact_ccd_audit_certificate(handle_.get(), &certificate));
        return detail::copy<std::uint8_t>(certificate, exact_ccd_certificate_data, exact_ccd_certificate_free);
    }

private:
    detail::Handle<exact_ccd_audit_t, exact_ccd_audit_free> handle_;
};

}  // namespace exact_ccd

#endif
