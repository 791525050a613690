/* The C interface of exact-ccd: exact continuous collision detection.
 *
 * Made from the Rust sources by cbindgen; do not edit. docs/c.md has the rules for all functions. */

#ifndef EXACT_CCD_H
#define EXACT_CCD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// The version of the binary interface. It grows with each change that a compiled caller notices.
#define EXACT_CCD_ABI_VERSION 1

// The outcome of a call.
typedef enum exact_ccd_status {
  // The results have been written.
  EXACT_CCD_STATUS_OK = 0,
  // An argument is wrong: a null pointer, an unknown kind, a distance or a time out of range.
  EXACT_CCD_STATUS_INVALID_ARGUMENT = 1,
  // Positions are wrong: their number, or a coordinate that is infinite or not a number.
  EXACT_CCD_STATUS_INVALID_POSITIONS = 2,
  // A mesh or a query names a vertex that does not exist, or a mesh is too large.
  EXACT_CCD_STATUS_INVALID_MESH = 3,
  // A defect of the library. The handle of the call may only be freed.
  EXACT_CCD_STATUS_INTERNAL = 4,
} exact_ccd_status;

// The result of a frame of an audit.
typedef enum exact_ccd_audit_result {
  // The mesh does not touch itself between the last frame and this one.
  EXACT_CCD_AUDIT_RESULT_FREE = 0,
  // An edge meets a face in the first frame.
  EXACT_CCD_AUDIT_RESULT_INTERSECTION = 1,
  // Two primitives touch, or come within the distance of the audit.
  EXACT_CCD_AUDIT_RESULT_CONTACT = 2,
} exact_ccd_audit_result;

// The kind of a query: the two primitives, and the order of its points.
typedef enum exact_ccd_kind {
  // A vertex and the three corners of a face: 4 points.
  EXACT_CCD_KIND_VERTEX_FACE = 0,
  // The two ends of an edge, and those of another edge: 4 points.
  EXACT_CCD_KIND_EDGE_EDGE = 1,
  // A vertex and the two ends of an edge: 3 points.
  EXACT_CCD_KIND_VERTEX_EDGE = 2,
  // Two vertices: 2 points.
  EXACT_CCD_KIND_VERTEX_VERTEX = 3,
} exact_ccd_kind;

// Examines the frames of a mesh one after the other, between which vertices move in straight lines.
typedef struct exact_ccd_audit exact_ccd_audit;

// The contacts of a step, the earliest first.
typedef struct exact_ccd_contacts exact_ccd_contacts;

// Finds contact in successive steps of one mesh. It keeps memory from step to step, and no answer
// depends on earlier steps.
typedef struct exact_ccd_detector exact_ccd_detector;

// The connectivity of a mesh: faces, edges and vertices. It never changes.
typedef struct exact_ccd_mesh exact_ccd_mesh;

// The first time at which two primitives touch or come within a distance, and the place.
typedef struct exact_ccd_impact_t {
  // The time, from 0 to 1, rounded down to `double`.
  double time;
  // True if the time is exactly that, false if it lies above.
  bool time_is_exact;
  // True if there is a normal.
  bool has_normal;
  // u and v, from 0 to 1: the points (1 - u - v) v1 + u v2 + v v3 of a face, or (1 - u) a0 + u a1
  // and (1 - v) b0 + v b1 of two edges. A vertex is an edge of length zero there: against an edge, the
  // point is (1 - v) b0 + v b1.
  double parameters[2];
  // The unit normal, from the second primitive towards the first; zero if there is none.
  double normal[3];
} exact_ccd_impact_t;

// Two primitives of a mesh that touch in a step, or come within the distance of the detector.
typedef struct exact_ccd_contact_t {
  // The kind of the pair, of `exact_ccd_kind`.
  uint32_t kind;
  // The index of the first primitive: the vertex, or the edge of the smaller index.
  uint32_t first;
  // The index of the second: the face, the edge or the vertex.
  uint32_t second;
  // The vertices, in the order of the kind; 4294967295 in the places that the kind does not use.
  uint32_t vertices[4];
  // Bounds of the distance at that time: 0 for a minimum distance of 0.
  double distance[2];
  // The time and the place.
  struct exact_ccd_impact_t impact;
} exact_ccd_contact_t;

// Decides if two vertices can collide; called from several threads at the same time. Two primitives
// can collide if any vertex of one can collide with any vertex of the other, the rule of the IPC
// Toolkit. Must return: no exception may leave it.
typedef bool (*exact_ccd_can_collide_t)(uint32_t, uint32_t, void*);

// Decides if two primitives, given by their vertices, can collide; called from several threads at the
// same time. The numbers of vertices are 1 and 3, 2 and 2, 1 and 2, or 1 and 1, as in the kinds of
// query; at rest 2 and 3, an edge and a face. Must return: no exception may leave it.
typedef bool (*exact_ccd_pair_can_collide_t)(const uint32_t*, size_t, const uint32_t*, size_t, void*);

// A closed interval of times, whose ends are rounded down to `double`. The end is rounded down as
// well: an interval that ends at 1 has `end` = 1.
typedef struct exact_ccd_interval_t {
  // The first time.
  double start;
  // The last time; that of `start` for a single moment.
  double end;
} exact_ccd_interval_t;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// An audit of a mesh, to be freed with `exact_ccd_audit_free`. `min_distance` is that of
// `exact_ccd_detector_set_min_distance`.
enum exact_ccd_status exact_ccd_audit_new(const struct exact_ccd_mesh *mesh,
                                          double min_distance,
                                          struct exact_ccd_audit **audit);

// Examines the next frame, and the step that leads to it. The first frame is examined at rest.
// `contact` is written unless the result is `EXACT_CCD_AUDIT_RESULT_FREE`.
//
// For an intersection, `contact->first` is the edge and `contact->second` the face, and nothing else
// of it is meaningful. A contact is in the step from the frame before: its time is 0 there and 1 at
// this frame; in the first frame it is 0.
enum exact_ccd_status exact_ccd_audit_examine(struct exact_ccd_audit *audit,
                                              const double *x,
                                              size_t vertex_count,
                                              enum exact_ccd_audit_result *result,
                                              struct exact_ccd_contact_t *contact);

// Frees an audit. Null is allowed.
void exact_ccd_audit_free(struct exact_ccd_audit *audit);

// The first time of each of `query_count` queries, rounded down to `double`; NaN for those whose
// primitives never come within `min_distance`.
//
// `x0` and `x1` are the positions of `vertex_count` vertices at t = 0 and t = 1. `vertices` has the
// indices of the vertices of each query, as many as the kind has points, in its order. `times` has
// room for `query_count` numbers. Runs on all threads of the library.
enum exact_ccd_status exact_ccd_batch_times(uint32_t kind,
                                            const double *x0,
                                            const double *x1,
                                            size_t vertex_count,
                                            const uint32_t *vertices,
                                            size_t query_count,
                                            double min_distance,
                                            double *times);

// `exact_ccd_batch_times` for vertices of different thickness: a number for each of the
// `vertex_count` vertices. That of a primitive is the largest of its vertices, and the distance of a
// query the sum of both, rounded up.
enum exact_ccd_status exact_ccd_batch_times_thick(uint32_t kind,
                                                  const double *x0,
                                                  const double *x1,
                                                  size_t vertex_count,
                                                  const uint32_t *vertices,
                                                  size_t query_count,
                                                  const double *thickness,
                                                  double *times);

// The number of contacts, and a pointer to the first, which is valid until the list is freed.
enum exact_ccd_status exact_ccd_contacts_data(const struct exact_ccd_contacts *contacts,
                                              const struct exact_ccd_contact_t **data,
                                              size_t *count);

// Frees a list of contacts. Null is allowed.
void exact_ccd_contacts_free(struct exact_ccd_contacts *contacts);

// The detector for steps of a mesh, to be freed with `exact_ccd_detector_free`.
enum exact_ccd_status exact_ccd_detector_new(const struct exact_ccd_mesh *mesh,
                                             struct exact_ccd_detector **detector);

// Frees a detector. Null is allowed.
void exact_ccd_detector_free(struct exact_ccd_detector *detector);

// Pairs count as in contact from this distance on: a finite number of at least 0, which is the
// default.
enum exact_ccd_status exact_ccd_detector_set_min_distance(struct exact_ccd_detector *detector,
                                                          double min_distance);

// A thickness for each of the `vertex_count` vertices. That of a primitive is the largest of its
// vertices; pairs count as in contact from the sum of both on, rounded up.
enum exact_ccd_status exact_ccd_detector_set_thickness(struct exact_ccd_detector *detector,
                                                       const double *thickness,
                                                       size_t vertex_count);

// A uniform distance as in `exact_ccd_detector_set_min_distance`, and a smaller one for pairs that
// start within it: these are in contact only if they come within `inner_distance`. For a line search
// that has to move on from there.
enum exact_ccd_status exact_ccd_detector_set_inner_distance(struct exact_ccd_detector *detector,
                                                            double min_distance,
                                                            double inner_distance);

// Only primitives of different groups can collide; `groups` has a number for each of the
// `vertex_count` vertices. It replaces an earlier rule.
enum exact_ccd_status exact_ccd_detector_set_groups(struct exact_ccd_detector *detector,
                                                    const uint32_t *groups,
                                                    size_t vertex_count);

// Only primitives that the callback allows can collide; all, if it is null. It replaces an earlier
// rule. `data` is passed on to the callback, which is called as long as the detector exists.
enum exact_ccd_status exact_ccd_detector_set_can_collide(struct exact_ccd_detector *detector,
                                                         exact_ccd_can_collide_t can_collide,
                                                         void *data);

// `exact_ccd_detector_set_can_collide` for a callback that decides about whole primitives.
enum exact_ccd_status exact_ccd_detector_set_pair_can_collide(struct exact_ccd_detector *detector,
                                                              exact_ccd_pair_can_collide_t can_collide,
                                                              void *data);

// Decides if a step is free of contact. `x0` and `x1` are the positions of the `vertex_count`
// vertices at t = 0 and t = 1. Ends soon after the first contact found.
enum exact_ccd_status exact_ccd_detector_is_free(struct exact_ccd_detector *detector,
                                                 const double *x0,
                                                 const double *x1,
                                                 size_t vertex_count,
                                                 bool *is_free);

// The earliest contact of a step; `contact` is written only if there is one. Positions as in
// `exact_ccd_detector_is_free`.
enum exact_ccd_status exact_ccd_detector_earliest_contact(struct exact_ccd_detector *detector,
                                                          const double *x0,
                                                          const double *x1,
                                                          size_t vertex_count,
                                                          bool *is_found,
                                                          struct exact_ccd_contact_t *contact);

// The contacts of a step whose first time is not after `until`, from 0 to 1, the earliest first; all
// for 1. The list is freed with `exact_ccd_contacts_free`. Positions as in `exact_ccd_detector_is_free`.
enum exact_ccd_status exact_ccd_detector_contacts(struct exact_ccd_detector *detector,
                                                  const double *x0,
                                                  const double *x1,
                                                  size_t vertex_count,
                                                  double until,
                                                  struct exact_ccd_contacts **contacts);

// A step that is certified to be free of contact: its size, from 0 to 1, and the positions at its
// end, which are written to `positions`.
//
// The size is at most `keep` times the time of impact of the full step, for 0 < `keep` <= 1, and 1
// if the full step is free. It is 0 if no positive size is certified: the mesh is in contact at the
// start, or within the smallest `double` of it. `positions` has room for `vertex_count` points, and
// may be `x0` or `x1`.
enum exact_ccd_status exact_ccd_detector_free_step(struct exact_ccd_detector *detector,
                                                   const double *x0,
                                                   const double *x1,
                                                   size_t vertex_count,
                                                   double keep,
                                                   double *size,
                                                   double *positions);

// The message of the last call on this thread that failed; empty if none has. It names the argument,
// the vertex or the query that is wrong. The string is valid until the next call that fails on this
// thread.
const char *exact_ccd_last_error(void);

// Decides if a mesh at rest passes through itself: if an edge and a face that can collide and have no
// common vertex have a common point. `edge` and `face` are the first such pair, written only if there
// is one; both may be null. The distance of the detector has no influence.
enum exact_ccd_status exact_ccd_detector_has_intersections(const struct exact_ccd_detector *detector,
                                                           const double *x,
                                                           size_t vertex_count,
                                                           bool *has_intersections,
                                                           uint32_t *edge,
                                                           uint32_t *face);

// A mesh of `face_count` faces, each three vertices from 0, and `edge_count` edges that may be
// edges of no face (rods), each two vertices. Vertices of no face and no edge are points.
//
// The edges of the mesh are those of its faces, each once, as pairs i < j sorted by j, then by i;
// then the given edges that are not among them, in the same order. Counts may be 0, and their
// arrays null then. The mesh is freed with `exact_ccd_mesh_free`.
enum exact_ccd_status exact_ccd_mesh_new(size_t vertex_count,
                                         const uint32_t *faces,
                                         size_t face_count,
                                         const uint32_t *edges,
                                         size_t edge_count,
                                         struct exact_ccd_mesh **mesh);

// The numbers of faces, edges (of faces first) and edges of no face.
enum exact_ccd_status exact_ccd_mesh_counts(const struct exact_ccd_mesh *mesh,
                                            size_t *face_count,
                                            size_t *edge_count,
                                            size_t *loose_edge_count);

// Writes the two vertices of each edge to `edges`, which has room for `edge_count` edges. Contacts
// name edges by their index here.
enum exact_ccd_status exact_ccd_mesh_edges(const struct exact_ccd_mesh *mesh,
                                           uint32_t *edges,
                                           size_t edge_count);

// Frees a mesh. Detectors of the mesh keep what they need. Null is allowed.
void exact_ccd_mesh_free(struct exact_ccd_mesh *mesh);

// Decides if two primitives come within a distance of each other in a time step; for
// `min_distance` = 0, if they touch. Exact.
//
// `points_t0` and `points_t1` are the points of the query, in the order of its kind, at t = 0 and at
// t = 1; in between, each moves in a straight line. `min_distance` is a finite number of at least 0.
enum exact_ccd_status exact_ccd_collides(uint32_t kind,
                                         const double *points_t0,
                                         const double *points_t1,
                                         double min_distance,
                                         bool *collides);

// The first time at which two primitives come within a distance of each other, rounded down to
// `double`; for `min_distance` = 0, at which they touch. It is 0 if they are within it at the
// start, and NaN if they never come within it.
//
// Arguments as in `exact_ccd_collides`.
enum exact_ccd_status exact_ccd_time_of_impact(uint32_t kind,
                                               const double *points_t0,
                                               const double *points_t1,
                                               double min_distance,
                                               double *time);

// The first time at which two primitives come within a distance of each other, with the closest
// points and the normal then. `impact` is written only if `collides` is.
//
// Arguments as in `exact_ccd_collides`.
enum exact_ccd_status exact_ccd_impact(uint32_t kind,
                                       const double *points_t0,
                                       const double *points_t1,
                                       double min_distance,
                                       bool *collides,
                                       struct exact_ccd_impact_t *impact);

// The times at which two primitives are within a distance of each other: the maximal closed
// intervals, in increasing order. For `min_distance` = 0, the times at which they touch.
//
// The first `capacity` intervals are written to `intervals`, which may be null for 0, and their
// number to `count`, even if that is larger. There are at most 32. Other arguments as in
// `exact_ccd_collides`.
enum exact_ccd_status exact_ccd_intervals(uint32_t kind,
                                          const double *points_t0,
                                          const double *points_t1,
                                          double min_distance,
                                          struct exact_ccd_interval_t *intervals,
                                          size_t capacity,
                                          size_t *count);

// Bounds of the distance of two primitives at a time of the step, which is in [0, 1]: the nearest
// `double` that are not above and not below it.
//
// `upper` is infinite if the distance exceeds all `double`. Other arguments as in
// `exact_ccd_collides`.
enum exact_ccd_status exact_ccd_distance_at(uint32_t kind,
                                            const double *points_t0,
                                            const double *points_t1,
                                            double time,
                                            double *lower,
                                            double *upper);

// Sets the number of threads of the library, 0 for the number of cores. To be called before any
// function of a batch or a detector; without it, the threads are as many as the cores.
//
// The number does not change any answer.
enum exact_ccd_status exact_ccd_set_threads(uint32_t count);

// The version of the library, such as "0.1.0". The string is never freed.
const char *exact_ccd_version(void);

// The `EXACT_CCD_ABI_VERSION` with which the library was compiled. A program that loads the library
// at run time compares it with that of its header.
uint32_t exact_ccd_abi_version(void);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* EXACT_CCD_H */
