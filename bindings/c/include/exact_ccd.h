/** @file
 * The C interface of exact-ccd: exact continuous collision detection.
 *
 * Made from the Rust sources by cbindgen; do not edit. docs/c.md has the rules for all functions. */

#ifndef EXACT_CCD_H
#define EXACT_CCD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/// The index of no vertex, no edge and no face.
#define EXACT_CCD_NONE 4294967295

/// The version of the binary interface. It grows with each change that a compiled caller notices.
#define EXACT_CCD_ABI_VERSION 3

/// The outcome of a call.
typedef enum exact_ccd_status_t {
  /// The results have been written.
  EXACT_CCD_STATUS_OK = 0,
  /// An argument is wrong: a null pointer, an unknown kind, a distance or a time out of range.
  EXACT_CCD_STATUS_INVALID_ARGUMENT = 1,
  /// Positions are wrong: their number, or a coordinate that is infinite or not a number.
  EXACT_CCD_STATUS_INVALID_POSITIONS = 2,
  /// A mesh or a query names a vertex that does not exist, or a mesh is too large.
  EXACT_CCD_STATUS_INVALID_MESH = 3,
  /// A defect of the library. The handle of the call may only be freed.
  EXACT_CCD_STATUS_INTERNAL = 4,
  /// An edge passes through a face at the start of the step, and the detector has the check of the
  /// start: see `exact_ccd_detector_set_start_check`.
  EXACT_CCD_STATUS_CROSSING = 5,
  /// Some pairs have no proof, or there is nothing to prove: there is no certificate.
  EXACT_CCD_STATUS_UNCERTIFIED = 6,
} exact_ccd_status_t;

/// The result of a frame of an audit.
typedef enum exact_ccd_audit_result_t {
  /// The mesh does not touch itself between the last frame and this one.
  EXACT_CCD_AUDIT_RESULT_FREE = 0,
  /// An edge meets a face in the first frame.
  EXACT_CCD_AUDIT_RESULT_INTERSECTION = 1,
  /// Two primitives touch, or come within the distance of the audit.
  EXACT_CCD_AUDIT_RESULT_CONTACT = 2,
} exact_ccd_audit_result_t;

/// The kind of a query: the two primitives, and the order of its points.
typedef enum exact_ccd_kind_t {
  /// A vertex and the three corners of a face: 4 points.
  EXACT_CCD_KIND_VERTEX_FACE = 0,
  /// The two ends of an edge, and the two ends of another edge: 4 points.
  EXACT_CCD_KIND_EDGE_EDGE = 1,
  /// A vertex and the two ends of an edge: 3 points.
  EXACT_CCD_KIND_VERTEX_EDGE = 2,
  /// Two vertices: 2 points.
  EXACT_CCD_KIND_VERTEX_VERTEX = 3,
  /// An edge and a face that meet at rest: the kind of an intersection, which is no query.
  EXACT_CCD_KIND_EDGE_FACE = 4,
} exact_ccd_kind_t;

/// Examines the frames of a mesh one after the other, between which vertices move in straight lines.
typedef struct exact_ccd_audit_t exact_ccd_audit_t;

/// The bytes of a certificate, which the program `exact-ccd-check` verifies with the mesh files.
/// `docs/certificates.md` has the format.
typedef struct exact_ccd_certificate_t exact_ccd_certificate_t;

/// The contacts of a step, the earliest first.
typedef struct exact_ccd_contacts_t exact_ccd_contacts_t;

/// Finds contact in successive steps of one mesh. It keeps memory from step to step, and no answer
/// depends on earlier steps.
typedef struct exact_ccd_detector_t exact_ccd_detector_t;

/// The connectivity of a mesh: faces, edges and vertices. It never changes.
typedef struct exact_ccd_mesh_t exact_ccd_mesh_t;

/// Pairs of primitives, sorted by kind, then by the first index, then by the second.
typedef struct exact_ccd_pairs_t exact_ccd_pairs_t;

/// The first time at which two primitives touch or come within a distance, and the place.
typedef struct exact_ccd_impact_t {
  /// The time, from 0 to 1, rounded down to `double`.
  double time;
  /// True if `time` is the exact time, false if the exact time lies above it.
  bool time_is_exact;
  /// True if there is a normal.
  bool has_normal;
  /// u and v, from 0 to 1: the points (1 - u - v) v1 + u v2 + v v3 of a face, or (1 - u) a0 + u a1
  /// and (1 - v) b0 + v b1 of two edges. A vertex is an edge of length zero there: against an edge, the
  /// point is (1 - v) b0 + v b1. With a face, u + v may be larger than 1 by rounding.
  double parameters[2];
  /// The unit normal, from the second primitive towards the first; zero if there is none.
  double normal[3];
  /// x, y and z of the points of the first and of the second primitive that touch or are closest at that
  /// time. They are rounded: at contact, both are the same up to a few units in the last place of the
  /// largest coordinate, and up to 2^-32 of the size of the primitives.
  double points[2][3];
} exact_ccd_impact_t;

/// Two primitives of a mesh that touch in a step, or come within the distance of the detector.
typedef struct exact_ccd_contact_t {
  /// The kind of the pair, of `exact_ccd_kind_t`; `EXACT_CCD_KIND_EDGE_FACE` for an intersection at rest.
  uint32_t kind;
  /// The index of the first primitive: the vertex, or the edge of the smaller index.
  uint32_t first;
  /// The index of the second: the face, the edge or the vertex.
  uint32_t second;
  /// The vertices, in the order of the kind; `EXACT_CCD_NONE` in the places that the kind does not use.
  uint32_t vertices[4];
  /// Bounds of the distance at that time: 0 for a minimum distance of 0.
  double distance[2];
  /// The time and the place.
  struct exact_ccd_impact_t impact;
} exact_ccd_contact_t;

/// Decides if two vertices can collide; called from several threads at the same time. Two primitives
/// can collide if any vertex of one can collide with any vertex of the other, the rule of the IPC
/// Toolkit. Must return: no exception may leave it.
typedef bool (*exact_ccd_can_collide_t)(uint32_t, uint32_t, void*);

/// Frees the data of a callback. Must return: no exception may leave it.
typedef void (*exact_ccd_destroy_t)(void*);

/// Decides if two primitives, given by their vertices, can collide; called from several threads at the
/// same time. The numbers of vertices are 1 and 3, 2 and 2, 1 and 2, or 1 and 1, as in the kinds of
/// query; at rest 2 and 3, an edge and a face. Must return: no exception may leave it.
typedef bool (*exact_ccd_pair_can_collide_t)(const uint32_t*, size_t, const uint32_t*, size_t, void*);

/// A call that failed.
typedef struct exact_ccd_error_t {
  /// The status that the call returned; `EXACT_CCD_STATUS_OK` if no call on this thread has failed.
  enum exact_ccd_status_t status;
  /// The message, as from `exact_ccd_last_error`.
  const char *message;
  /// True if `query` has a meaning.
  bool has_query;
  /// The index, from 0, of the first query of a batch that is wrong; 0 if there is none.
  size_t query;
  /// The edge that passes through a face, for `EXACT_CCD_STATUS_CROSSING`; else `EXACT_CCD_NONE`.
  uint32_t edge;
  /// That face; else `EXACT_CCD_NONE`.
  uint32_t face;
} exact_ccd_error_t;

/// Two primitives of a mesh.
typedef struct exact_ccd_pair_t {
  /// The kind of the pair, of `exact_ccd_kind_t`.
  uint32_t kind;
  /// The index of the first primitive: the vertex, or the edge of the smaller index.
  uint32_t first;
  /// The index of the second: the face, the edge or the vertex.
  uint32_t second;
  /// The vertices, in the order of the kind; `EXACT_CCD_NONE` in the places that the kind does not use.
  uint32_t vertices[4];
} exact_ccd_pair_t;

/// A closed interval of times, whose ends are rounded down to `double`. The end is rounded down as
/// well: an interval that ends at 1 has `end` = 1.
typedef struct exact_ccd_interval_t {
  /// The first time.
  double start;
  /// The last time; equal to `start` for a single moment.
  double end;
} exact_ccd_interval_t;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/// An audit of a mesh, to be freed with `exact_ccd_audit_free`. `min_distance` has the meaning that it has
/// in `exact_ccd_detector_set_min_distance`.
enum exact_ccd_status_t exact_ccd_audit_new(const struct exact_ccd_mesh_t *mesh,
                                            double min_distance,
                                            struct exact_ccd_audit_t **audit);

/// The number of threads of an audit, as in `exact_ccd_detector_set_threads`.
enum exact_ccd_status_t exact_ccd_audit_set_threads(struct exact_ccd_audit_t *audit,
                                                    uint32_t count);

/// Examines the next frame, and the step that leads to it. The first frame is examined at rest.
/// `contact` is written unless the result is `EXACT_CCD_AUDIT_RESULT_FREE`.
///
/// For an intersection, `contact->kind` is `EXACT_CCD_KIND_EDGE_FACE`, `contact->first` the edge and
/// `contact->second` the face; the vertices are `EXACT_CCD_NONE`, and all other numbers 0. A contact is in
/// the step from the frame before: its time is 0 there and 1 at this frame; in the first frame it is 0.
enum exact_ccd_status_t exact_ccd_audit_examine(struct exact_ccd_audit_t *audit,
                                                const double *x,
                                                size_t vertex_count,
                                                enum exact_ccd_audit_result_t *result,
                                                struct exact_ccd_contact_t *contact);

/// Frees an audit. Null is allowed.
void exact_ccd_audit_free(struct exact_ccd_audit_t *audit);

/// `exact_ccd_time_of_impact` of each of `query_count` queries.
///
/// `x0` and `x1` are the positions of `vertex_count` vertices at t = 0 and t = 1. `vertices` has the
/// indices of the vertices of each query, as many as the kind has points, in its order. `separation`
/// and `until` are as in `exact_ccd_collides`. `threads` is the number of threads of this call: from 1
/// to 1024, or 0 for the number that `exact_ccd_set_threads` has set. `times` has room for
/// `query_count` numbers.
enum exact_ccd_status_t exact_ccd_batch_time_of_impact(uint32_t kind,
                                                       const double *x0,
                                                       const double *x1,
                                                       size_t vertex_count,
                                                       const uint32_t *vertices,
                                                       size_t query_count,
                                                       double separation,
                                                       double until,
                                                       uint32_t threads,
                                                       double *times);

/// `exact_ccd_batch_time_of_impact` for vertices of different thickness: a number for each of the
/// `vertex_count` vertices. A primitive has the largest thickness of its vertices. The separation of a query
/// is the sum of its two thicknesses, rounded up.
enum exact_ccd_status_t exact_ccd_batch_time_of_impact_thick(uint32_t kind,
                                                             const double *x0,
                                                             const double *x1,
                                                             size_t vertex_count,
                                                             const uint32_t *vertices,
                                                             size_t query_count,
                                                             const double *thickness,
                                                             double until,
                                                             uint32_t threads,
                                                             double *times);

/// Only primitives that the callback allows can collide; all, if it is null. It replaces an earlier
/// rule. `data` is passed on to the callback, which is called as long as it is the rule of the detector.
enum exact_ccd_status_t exact_ccd_detector_set_can_collide(struct exact_ccd_detector_t *detector,
                                                           exact_ccd_can_collide_t can_collide,
                                                           void *data);

/// `exact_ccd_detector_set_can_collide` with data that belongs to the detector: `destroy` is called with
/// it once, when another rule replaces this one or the detector is freed; for a null callback, before
/// this call returns. If the call fails, the data belongs to the caller. `destroy` may be null.
enum exact_ccd_status_t exact_ccd_detector_set_can_collide_owned(struct exact_ccd_detector_t *detector,
                                                                 exact_ccd_can_collide_t can_collide,
                                                                 void *data,
                                                                 exact_ccd_destroy_t destroy);

/// `exact_ccd_detector_set_can_collide` for a callback that decides about whole primitives.
enum exact_ccd_status_t exact_ccd_detector_set_pair_can_collide(struct exact_ccd_detector_t *detector,
                                                                exact_ccd_pair_can_collide_t can_collide,
                                                                void *data);

/// `exact_ccd_detector_set_can_collide_owned` for a callback that decides about whole primitives.
enum exact_ccd_status_t exact_ccd_detector_set_pair_can_collide_owned(struct exact_ccd_detector_t *detector,
                                                                      exact_ccd_pair_can_collide_t can_collide,
                                                                      void *data,
                                                                      exact_ccd_destroy_t destroy);

/// The number of bytes, and a pointer to the first, which is valid until the certificate is freed.
enum exact_ccd_status_t exact_ccd_certificate_data(const struct exact_ccd_certificate_t *certificate,
                                                   const uint8_t **data,
                                                   size_t *count);

/// Frees a certificate. Null is allowed.
void exact_ccd_certificate_free(struct exact_ccd_certificate_t *certificate);

/// The proof of the answer to a step: the step is free of contact until the earliest contact, and has this
/// contact. With `at_rest`, it also proves that no edge passes through a face at `x0`. It has the bytes of
/// `exact-ccd step --certificate`, and is freed with `exact_ccd_certificate_free`. Other arguments as in
/// `exact_ccd_detector_collides`.
///
/// The status is `EXACT_CCD_STATUS_UNCERTIFIED` if some pairs have no proof, `EXACT_CCD_STATUS_CROSSING` if
/// an edge passes through a face where that is to be excluded, and `EXACT_CCD_STATUS_INVALID_ARGUMENT` for a
/// detector with groups, a callback, thicknesses or an inner distance.
enum exact_ccd_status_t exact_ccd_detector_certificate(struct exact_ccd_detector_t *detector,
                                                       const double *x0,
                                                       const double *x1,
                                                       size_t vertex_count,
                                                       bool at_rest,
                                                       struct exact_ccd_certificate_t **certificate);

/// Makes a certificate of all frames that follow. No frame may have been examined.
enum exact_ccd_status_t exact_ccd_audit_certify(struct exact_ccd_audit_t *audit);

/// The proof of the results of an audit so far, after `exact_ccd_audit_certify`: the bytes of
/// `exact-ccd audit --certificate`, about the frames up to the last one that was examined, or up to the first
/// violation. It is freed with `exact_ccd_certificate_free`.
///
/// The status is `EXACT_CCD_STATUS_UNCERTIFIED` if some pairs have no proof, and if there is nothing to
/// prove: for a single frame, or if the first frame has a violation.
enum exact_ccd_status_t exact_ccd_audit_certificate(const struct exact_ccd_audit_t *audit,
                                                    struct exact_ccd_certificate_t **certificate);

/// The detector for steps of a mesh, to be freed with `exact_ccd_detector_free`.
enum exact_ccd_status_t exact_ccd_detector_new(const struct exact_ccd_mesh_t *mesh,
                                               struct exact_ccd_detector_t **detector);

/// Frees a detector. Null is allowed.
void exact_ccd_detector_free(struct exact_ccd_detector_t *detector);

/// Decides if any two primitives touch in a step. `x0` and `x1` are the positions of the `vertex_count`
/// vertices at t = 0 and t = 1. `until`, from 0 to 1, is the last time that counts, 1 for the whole step:
/// primitives that first touch later do not collide. The exact time is compared, not the rounded one. Ends
/// soon after the first contact found.
///
/// A mesh that is pierced at `x0`, by an edge that passes through a face, may be free of contact: without
/// `exact_ccd_detector_set_start_check`, this is not found. docs/pairs.md has the pairs that are compared.
enum exact_ccd_status_t exact_ccd_detector_collides(struct exact_ccd_detector_t *detector,
                                                    const double *x0,
                                                    const double *x1,
                                                    size_t vertex_count,
                                                    double until,
                                                    bool *collides);

/// The earliest contact of a step; `contact` is written only if `collides` is true. Other arguments as in
/// `exact_ccd_detector_collides`.
enum exact_ccd_status_t exact_ccd_detector_collision(struct exact_ccd_detector_t *detector,
                                                     const double *x0,
                                                     const double *x1,
                                                     size_t vertex_count,
                                                     double until,
                                                     bool *collides,
                                                     struct exact_ccd_contact_t *contact);

/// All contacts of a step, the earliest first. The list is freed with `exact_ccd_contacts_free`. Other
/// arguments as in `exact_ccd_detector_collides`.
enum exact_ccd_status_t exact_ccd_detector_collisions(struct exact_ccd_detector_t *detector,
                                                      const double *x0,
                                                      const double *x1,
                                                      size_t vertex_count,
                                                      double until,
                                                      struct exact_ccd_contacts_t **contacts);

/// Pairs count as in contact from this distance on: a finite number of at least 0, which is the
/// default.
///
/// A vertex and an edge of rods that another edge connects are in contact at distance 0 only; `docs/pairs.md`
/// has the reason.
enum exact_ccd_status_t exact_ccd_detector_set_min_distance(struct exact_ccd_detector_t *detector,
                                                            double min_distance);

/// A thickness for each of the `vertex_count` vertices. A primitive has the largest thickness of its
/// vertices. Pairs count as in contact from the sum of both thicknesses on, rounded up.
enum exact_ccd_status_t exact_ccd_detector_set_thickness(struct exact_ccd_detector_t *detector,
                                                         const double *thickness,
                                                         size_t vertex_count);

/// A uniform distance as in `exact_ccd_detector_set_min_distance`, and a smaller one for pairs that start
/// within it: these are in contact only if they come within `inner_distance`. So a line search can move on
/// from such a start. An inner distance that is not smaller changes nothing.
enum exact_ccd_status_t exact_ccd_detector_set_inner_distance(struct exact_ccd_detector_t *detector,
                                                              double min_distance,
                                                              double inner_distance);

/// Primitives all of whose vertices have the same number do not collide; `groups` has a number for each of
/// the `vertex_count` vertices. It replaces an earlier rule.
enum exact_ccd_status_t exact_ccd_detector_set_groups(struct exact_ccd_detector_t *detector,
                                                      const uint32_t *groups,
                                                      size_t vertex_count);

/// The number of threads of a detector: from 1 to 1024, or 0 for the number that `exact_ccd_set_threads`
/// has set, which is the default. The number does not change any answer.
enum exact_ccd_status_t exact_ccd_detector_set_threads(struct exact_ccd_detector_t *detector,
                                                       uint32_t count);

/// Turns the check of the start on or off; it is off in a new detector. With it, an answer about a step
/// has the status `EXACT_CCD_STATUS_CROSSING` if an edge passes through a face at `x0`, among the pairs
/// that can collide; `exact_ccd_last_error_fields` has both. Primitives that merely touch are contacts at
/// t = 0, as always.
///
/// The check is a pass over the mesh at rest. No pass is made if `x0` is, bit for bit, the start of the
/// step before, or, without groups and without a callback, the end of the last step that was found free.
enum exact_ccd_status_t exact_ccd_detector_set_start_check(struct exact_ccd_detector_t *detector,
                                                           bool is_on);

/// A step that is certified to be free of contact: its size, from 0 to 1, and the positions at its
/// end, which are written to `positions`.
///
/// The size is at most `keep` times the time of impact of the full step, for 0 < `keep` <= 1, and 1
/// if the full step is free. It is 0 if none of the sizes that are tried is certified: the mesh touches
/// itself at the start, or is nearer to itself there than rounded positions are to the path. `positions` has
/// room for `vertex_count` points, and may be `x0` or `x1`.
///
/// `collides` is true if the full step has a contact. Then the earliest one is written to `contact`; else
/// `contact` is not written. Both may be null.
///
/// A mesh that is pierced at `x0`, by an edge that passes through a face, may be free of contact, and the
/// size is 1: without `exact_ccd_detector_set_start_check`, this is not found. docs/pairs.md has the pairs
/// that are compared.
enum exact_ccd_status_t exact_ccd_detector_free_step(struct exact_ccd_detector_t *detector,
                                                     const double *x0,
                                                     const double *x1,
                                                     size_t vertex_count,
                                                     double keep,
                                                     double *size,
                                                     double *positions,
                                                     bool *collides,
                                                     struct exact_ccd_contact_t *contact);

/// A size for each vertex, such that the motion of all vertices is certified to be free of contact: the
/// sizes, from 0 to 1, are written to `sizes`, and the positions at the end to `positions`.
///
/// The motion from `x0` to `positions`, as they are, has been decided exactly: the pairs in `blocked` touch,
/// and no others. They touch at t = 0, or their vertices that are not pinned stay at the start. `pinned` has
/// the `pinned_count` vertices that go all the way, such as the vertices of obstacles; it may be null for 0.
/// Without pinned vertices, no size is below the size of `exact_ccd_detector_free_step`.
///
/// A contact at time t holds back the vertices that approach, in the first round by the factor `keep` t,
/// for 0 < `keep` <= 1; docs/steps.md has the rule. `rounds` is the number of searches for contact.
///
/// `sizes` has room for `vertex_count` numbers, and `positions` for as many points; `positions` may be
/// `x0` or `x1`. The list `blocked` is freed with `exact_ccd_pairs_free`. A mesh that is pierced at `x0`
/// may be free of contact, as in `exact_ccd_detector_collides`.
enum exact_ccd_status_t exact_ccd_detector_free_steps(struct exact_ccd_detector_t *detector,
                                                      const double *x0,
                                                      const double *x1,
                                                      size_t vertex_count,
                                                      const uint32_t *pinned,
                                                      size_t pinned_count,
                                                      double keep,
                                                      double *sizes,
                                                      double *positions,
                                                      size_t *rounds,
                                                      struct exact_ccd_pairs_t **blocked);

/// All contacts of a step, the earliest first, and the first one of each vertex: for methods that limit the
/// displacement of each vertex by a rule of their own.
///
/// `first` has room for `vertex_count` numbers. For each vertex, it has the index, in `contacts`, of the
/// first contact of a pair to which the vertex belongs, or the number of contacts if there is none. `times`
/// has room for as many numbers: the time of this contact, rounded down, or infinity. The list `contacts` is
/// freed with `exact_ccd_contacts_free`. Other arguments as in `exact_ccd_detector_collides`.
enum exact_ccd_status_t exact_ccd_detector_first_contacts(struct exact_ccd_detector_t *detector,
                                                          const double *x0,
                                                          const double *x1,
                                                          size_t vertex_count,
                                                          double until,
                                                          size_t *first,
                                                          double *times,
                                                          struct exact_ccd_contacts_t **contacts);

/// The clearance of each vertex at rest: the least distance between a primitive that has the vertex and
/// a primitive that can collide with it, or `cut_off` if all are farther apart. It is rounded down to a
/// `double`.
///
/// If each vertex of a mesh moves by less than half of its clearance, on whatever path, the motion is free
/// of contact (docs/steps.md). The minimum distance of the detector has no part in it. `clearances` has room
/// for `vertex_count` numbers, and `cut_off` is finite and at least 0.
enum exact_ccd_status_t exact_ccd_detector_clearances(struct exact_ccd_detector_t *detector,
                                                      const double *x,
                                                      size_t vertex_count,
                                                      double cut_off,
                                                      double *clearances);

/// The message of the last call on this thread that failed; empty if none has. It names the argument,
/// the vertex or the query that is wrong. The string is valid until the next call that fails on this
/// thread.
const char *exact_ccd_last_error(void);

/// The last call on this thread that failed, with the query, the edge and the face that are wrong as
/// numbers. The message is valid as long as the one that `exact_ccd_last_error` returns.
struct exact_ccd_error_t exact_ccd_last_error_fields(void);

/// Decides if a mesh at rest passes through itself: if an edge and a face that can collide and have no
/// common vertex have a common point. `edge` and `face` are the first such pair, written only if there
/// is one. Both may be null: then the search ends with any pair. The distance of the detector has no
/// influence.
enum exact_ccd_status_t exact_ccd_detector_has_intersections(const struct exact_ccd_detector_t *detector,
                                                             const double *x,
                                                             size_t vertex_count,
                                                             bool *has_intersections,
                                                             uint32_t *edge,
                                                             uint32_t *face);

/// The number of contacts, and a pointer to the first, which is valid until the list is freed.
enum exact_ccd_status_t exact_ccd_contacts_data(const struct exact_ccd_contacts_t *contacts,
                                                const struct exact_ccd_contact_t **data,
                                                size_t *count);

/// The number of pairs, and a pointer to the first, which is valid until the list is freed.
enum exact_ccd_status_t exact_ccd_pairs_data(const struct exact_ccd_pairs_t *pairs,
                                             const struct exact_ccd_pair_t **data,
                                             size_t *count);

/// Frees a list of contacts. Null is allowed.
void exact_ccd_contacts_free(struct exact_ccd_contacts_t *contacts);

/// Frees a list of pairs. Null is allowed.
void exact_ccd_pairs_free(struct exact_ccd_pairs_t *pairs);

/// A mesh of `face_count` faces, each three vertices from 0, and `edge_count` edges that may be
/// edges of no face (rods), each two vertices. Vertices of no face and no edge are points.
///
/// The edges of the mesh are the edges of its faces, each once, as pairs i < j sorted by j, then by i; then
/// the given edges that are not among them, in the same order. Counts may be 0, and their arrays null then.
/// The mesh is freed with `exact_ccd_mesh_free`.
enum exact_ccd_status_t exact_ccd_mesh_new(size_t vertex_count,
                                           const uint32_t *faces,
                                           size_t face_count,
                                           const uint32_t *edges,
                                           size_t edge_count,
                                           struct exact_ccd_mesh_t **mesh);

/// The numbers of faces, edges (of faces first) and edges of no face.
enum exact_ccd_status_t exact_ccd_mesh_counts(const struct exact_ccd_mesh_t *mesh,
                                              size_t *face_count,
                                              size_t *edge_count,
                                              size_t *loose_edge_count);

/// Writes the two vertices of each edge to `edges`, which has room for `edge_count` edges. Contacts
/// name edges by their index here.
enum exact_ccd_status_t exact_ccd_mesh_edges(const struct exact_ccd_mesh_t *mesh,
                                             uint32_t *edges,
                                             size_t edge_count);

/// Frees a mesh. Detectors of the mesh keep what they need. Null is allowed.
void exact_ccd_mesh_free(struct exact_ccd_mesh_t *mesh);

/// Decides if two primitives touch in a time step: if they come within the distance `separation` of each
/// other, or are in contact if it is 0. Exact.
///
/// `x0` and `x1` are the points of the query, in the order of its kind, at t = 0 and at t = 1; in
/// between, each moves in a straight line. `separation` is a finite number of at least 0. `until` is
/// the last time that counts, 1 for the whole step: primitives that first touch later do not collide.
/// The exact time is compared, not the rounded one; `until` may be any number but NaN.
enum exact_ccd_status_t exact_ccd_collides(uint32_t kind,
                                           const double *x0,
                                           const double *x1,
                                           double separation,
                                           double until,
                                           bool *collides);

/// The first time at which two primitives touch, rounded down to `double`. It is 0 if they touch at the
/// start, and NaN if they do not collide.
///
/// Arguments as in `exact_ccd_collides`.
enum exact_ccd_status_t exact_ccd_time_of_impact(uint32_t kind,
                                                 const double *x0,
                                                 const double *x1,
                                                 double separation,
                                                 double until,
                                                 double *time);

/// The first time at which two primitives touch, with the closest points and the normal then. `impact`
/// is written only if `collides` is.
///
/// Arguments as in `exact_ccd_collides`.
enum exact_ccd_status_t exact_ccd_impact(uint32_t kind,
                                         const double *x0,
                                         const double *x1,
                                         double separation,
                                         double until,
                                         bool *collides,
                                         struct exact_ccd_impact_t *impact);

/// The times at which two primitives touch: the maximal closed intervals, in increasing order; none if
/// the first is after `until`.
///
/// The first `capacity` intervals are written to `intervals`, which may be null for 0, and their
/// number to `count`, even if that is larger. There are at most 32. Other arguments as in
/// `exact_ccd_collides`.
enum exact_ccd_status_t exact_ccd_intervals(uint32_t kind,
                                            const double *x0,
                                            const double *x1,
                                            double separation,
                                            double until,
                                            struct exact_ccd_interval_t *intervals,
                                            size_t capacity,
                                            size_t *count);

/// Bounds of the distance of two primitives at a time of the step, which is in [0, 1]: the nearest
/// `double` that are not above and not below it.
///
/// `upper` is infinite if the distance exceeds all `double`. Other arguments as in
/// `exact_ccd_collides`.
enum exact_ccd_status_t exact_ccd_distance_at(uint32_t kind,
                                              const double *x0,
                                              const double *x1,
                                              double time,
                                              double *lower,
                                              double *upper);

/// Sets the number of threads of the calls, detectors and audits that have none of their own: from 1 to
/// 1024, or 0 for the number of cores, which it is without this call. It holds from the next call on, on
/// all threads of the process.
///
/// The number does not change any answer. The threads are kept until there is another number.
enum exact_ccd_status_t exact_ccd_set_threads(uint32_t count);

/// The version of the library, such as "0.1.0". The string is never freed.
const char *exact_ccd_version(void);

/// The `EXACT_CCD_ABI_VERSION` with which the library was compiled. A program that loads the library at run
/// time compares it with the number in its header.
uint32_t exact_ccd_abi_version(void);

/// `exact_ccd_detector_collides` for each of `world_count` worlds, with the mesh and the settings of the
/// detector.
///
/// `x0` and `x1` have the positions of the `vertex_count` vertices of the first world, then of the next one,
/// and so on. `collides` has room for `world_count` results. The message of an error names the first world
/// that is wrong, from 0.
enum exact_ccd_status_t exact_ccd_worlds_collides(const struct exact_ccd_detector_t *detector,
                                                  const double *x0,
                                                  const double *x1,
                                                  size_t vertex_count,
                                                  size_t world_count,
                                                  double until,
                                                  bool *collides);

/// `exact_ccd_detector_collision` for each world; `collides` and `contacts` have room for `world_count`
/// results, and a contact is written only where `collides` is true. Other arguments as in
/// `exact_ccd_worlds_collides`.
enum exact_ccd_status_t exact_ccd_worlds_collision(const struct exact_ccd_detector_t *detector,
                                                   const double *x0,
                                                   const double *x1,
                                                   size_t vertex_count,
                                                   size_t world_count,
                                                   double until,
                                                   bool *collides,
                                                   struct exact_ccd_contact_t *contacts);

/// `exact_ccd_detector_collisions` for each world: one list with the contacts of the first world, then of
/// the next one, and so on. `counts` has room for `world_count` numbers of contacts. Other arguments as in
/// `exact_ccd_worlds_collides`.
enum exact_ccd_status_t exact_ccd_worlds_collisions(const struct exact_ccd_detector_t *detector,
                                                    const double *x0,
                                                    const double *x1,
                                                    size_t vertex_count,
                                                    size_t world_count,
                                                    double until,
                                                    size_t *counts,
                                                    struct exact_ccd_contacts_t **contacts);

/// `exact_ccd_detector_free_step` for each world: `sizes` has room for `world_count` numbers, and
/// `positions` for the points of all worlds. `positions` may be `x0` or `x1`. `collides` and `contacts` are
/// about the full steps, as in `exact_ccd_worlds_collision`; both may be null. Other arguments as in
/// `exact_ccd_worlds_collides`.
enum exact_ccd_status_t exact_ccd_worlds_free_step(const struct exact_ccd_detector_t *detector,
                                                   const double *x0,
                                                   const double *x1,
                                                   size_t vertex_count,
                                                   size_t world_count,
                                                   double keep,
                                                   double *sizes,
                                                   double *positions,
                                                   bool *collides,
                                                   struct exact_ccd_contact_t *contacts);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* EXACT_CCD_H */
