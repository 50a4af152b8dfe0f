/* surfpath: shortest paths on smooth surfaces. The exported functions and the structs that cross to JavaScript; reference manual of the
 * core.
 *
 * The core is pure: it works in memory that the caller hands in, never allocates, prints, aborts or recurses, and leaves no state behind.
 * Equations and measurements: MATH.md. A surface is a pair of functions (surface.h); units are those of the surface's coordinates.
 * Structs hold double, int32_t and pointers; in WebAssembly a pointer is four bytes, and the offsets asserted at the end hold. */
#ifndef SURFPATH_H
#define SURFPATH_H

#include "arena.h"
#include "graph.h"
#include "graph_field.h"
#include "mesh.h"
#include "status.h"
#include "surface.h"

enum sp_algorithm {
    SP_ELEMENTS = 0, /* high-order elements, as many as the tolerance asks for */
    SP_POLYLINE = 1, /* covariant Newton on a polyline of chords, shifted until positive definite, certified by its Morse index */
    SP_PAPER = 2     /* the paper's: coordinate Hessian, sign test (Eq. 25, 26), interpolating line search */
};

/* What to compute besides the ends. Fill with sp_default_options, then change. */
struct sp_options {
    double tolerance;          /* SP_ELEMENTS: wanted relative error of the length and of positions over the length; at least 1e-15 */
    double gradient_tolerance; /* > 0: stop at |grad E| <= this (Eq. 19's factor n + 1; units length^2 per coordinate); 0: at a relative
                                  Newton decrement of 1e-7. SP_PAPER reads 0 as 1e-6 */
    int32_t algorithm;         /* enum sp_algorithm */
    int32_t point_count;       /* K, unknown inner points: 1 … 100,000 */
    int32_t max_iterations;    /* Newton steps, of all stages together, 0 … 10,000 */
    int32_t record;            /* 1: keep the polyline of every iterate */
};

/* How a path passes a point to which an edge of the rectangle collapses, a pole, or nearly so, a hole. */
enum sp_way {
    SP_FREE = 0,        /* as it comes */
    SP_OVER_POINT = 1,  /* through it: two arcs */
    SP_POINT_CHART = 2, /* in a chart around it, from the start or the straight line in it, where the surface closes around it */
    SP_BESIDE_POINT = 3 /* on elements that close in on it: past it or, if it lies beyond the edge, around that, as around a hole */
};

struct sp_passage {
    int32_t way;   /* enum sp_way; SP_ELEMENTS on parametric surfaces only */
    int32_t edge;  /* 2 * coordinate + side; of any other number the way is free */
    double beyond; /* how far beyond the edge the point lies, in the coordinate across */
    double turn;   /* what the coordinate along the edge changes by once around; 0: there are walls, and no chart */
};

/* The two ends, where to start from, and how. */
struct sp_request {
    double from[3]; /* parametric: u, v; implicit: x, y, z, near the surface */
    double to[3];
    const double *start; /* start_count points of 2 (parametric) or 3 numbers, resampled by length to K + 2, SP_ELEMENTS to at most 257, its
                            ends moved to from and to. NULL: the straight line from end to end, solved from the lexicographically smaller
                            end, so that exchanging the ends reverses the path to the bit */
    int32_t start_count; /* 0 without start, else at least 2 */
    struct sp_passage passage;
};

/* One Newton step. The last entry is where the path came to rest; its step is 0. Where a path is refined, the energies before are
 * multiplied by what the same path has more on the finer discretisation, so that they fall from step to step. */
struct sp_iterate {
    double energy;        /* E = (n + 1) sum |chord|^2, Eq. 19 */
    double gradient_norm; /* |grad E| */
    double decrement;     /* sqrt(g' H^-1 g / E), scale-free; NaN where H is not positive definite */
    double step;          /* accepted step length, 1 = a full Newton step */
};

struct sp_result {
    double length;        /* SP_ELEMENTS: of the curve; else the sum of the chords; NaN without a path */
    double length_error;  /* estimate of |length - length of the geodesic|, never below 4e-15 length */
    double energy;        /* Eq. 19 */
    double gradient_norm; /* |grad E| over all free unknowns */
    double rounding;      /* what rounding of the coordinates alone may do to the length */
    double pull[2][3];  /* SP_ELEMENTS in one piece: derivative of the length by u v or x y z of each end, in directions along the surface;
                           else NaN */
    double *points;     /* 3 (K + 2): x y z, ends included; in the arena, as all pointers here; NULL without a path or positions */
    double *parameters; /* 2 (K + 2): u v; NULL for an implicit surface */
    struct sp_iterate *history; /* history_count entries */
    double *record;             /* history_count polylines of 3 (K + 2), or NULL */
    int32_t status;             /* enum sp_status */
    int32_t iterations;         /* Newton steps taken, whatever the status */
    int32_t work;               /* how often a node was moved, by steps and by what was tried of them, whatever the status */
    int32_t index;              /* Morse index: negative pivots of the Hessian at the end; -1: not computed */
    int32_t touches_boundary;   /* 1: an inner point lies on an edge of the rectangle */
    int32_t history_count;
    int32_t crosses_singularity; /* 1: the path crosses a curve where S_u x S_v vanishes; SP_SINGULAR_METRIC: that is why */
};

/* Writes the defaults: SP_ELEMENTS, tolerance 1e-9, K = 64, 200 iterations, no record. */
void sp_default_options(struct sp_options *options);

/* Bytes of arena that sp_solve_path needs for these options on this surface (start_count: of the request); monotone in K. */
double sp_solve_bytes(const struct sp_surface *surface, const struct sp_options *options, int32_t start_count);

/* Computes a locally shortest path between two points.
 *
 * Minimises E = (n + 1) sum |X_i+1 - X_i|^2 over n = K points on the surface by Newton's method (MATH.md); where length has a
 * metric of its own (surface.h), E = sum of its chords' squares by the trapezoidal rule. `result` is always filled; its
 * arrays lie in `arena`, which is reset first. Returns result->status: SP_CONVERGED, SP_ITERATION_LIMIT, SP_STALLED, SP_ILL_CONDITIONED,
 * SP_SADDLE, SP_TOLERANCE_NOT_MET with a path; SP_SINGULAR_METRIC, SP_SHEET_JUMP, SP_OFF_SURFACE, SP_NOT_FINITE, SP_OUT_OF_MEMORY without.
 * Options out of range are the caller's mistake and are clamped. Cost: O(K) a step. */
int32_t sp_solve_path(const struct sp_surface *surface, const struct sp_request *request, const struct sp_options *options,
                      struct sp_arena *arena, struct sp_result *result);

/* Finds the point of the surface closest to `point` (three numbers), from `place` downhill: Newton on the squared distance, safeguarded.
 *
 * `surface`: SP_INDUCED, as distance in space is asked for. `place`: in and out, u v or x y z; an implicit surface is first reached from it
 * by Eq. 37. Parametric: stays in the rectangle. Returns SP_CONVERGED, SP_STALLED (no closer point found, but not stationary to 1e-10),
 * SP_OFF_SURFACE, SP_NOT_FINITE; `place` is unchanged by the last two. */
int32_t sp_project_point(const struct sp_surface *surface, const double point[3], double place[3]);

/* Where a geodesic starts, and how far it goes. */
struct sp_trace_request {
    double from[3];      /* parametric: u, v; implicit: x, y, z, near the surface */
    double direction[3]; /* du, dv, or a vector of space whose tangent part counts; of any length but 0 */
    double length;       /* >= 0; SP_NOT_FINITE if it is not */
};

struct sp_trace_options {
    double tolerance;    /* largest error of a step, of the direction and relative to the step's length: 1e-14 … 1e-2 */
    int32_t point_count; /* K, points between the two ends: 1 … 100,000 */
    int32_t max_steps;   /* steps, rejected ones too: 1 … 10,000,000 */
};

struct sp_trace_result {
    double length;       /* as asked, or up to where the trace ended; NaN without a path */
    double length_error; /* estimate of the distance between the end and that of the geodesic, never below 4e-15 length */
    double conjugate;    /* length at which the first point conjugate to the start lies, NaN if it is not on the path; not looked for on
                            implicit surfaces with a tensor */
    double velocity[3];  /* du, dv, 0 or dx, dy, dz by length, at the end */
    double turn_error;   /* estimate of the angle between it and that of the geodesic */
    double field[2];     /* at the end, the Jacobi field that vanishes at the start with slope 1, and its slope; below 1e100 lengths */
    double *points;      /* 3 (K + 2): x y z, equally spaced by length, ends included; in the arena; NULL without a path or positions */
    double *parameters;  /* 2 (K + 2): u v, continuous across seams, in the rectangle; NULL for an implicit surface */
    int32_t status;      /* enum sp_status */
    int32_t steps;       /* accepted steps */
    int32_t touches_boundary; /* 1: an inner point lies on an edge of the rectangle */
    int32_t normal;           /* 1: the direction has no tangent part, the caller's mistake: no path */
};

/* Writes the defaults: tolerance 1e-12, K = 64, 200,000 steps. */
void sp_default_trace_options(struct sp_trace_options *options);

/* Bytes of arena that sp_trace_path needs for these options on a surface of this kind. */
double sp_trace_bytes(int32_t kind, const struct sp_trace_options *options);

/* Follows the geodesic of the metric in use from a point in a direction: the exponential map, by DOP853, with the Jacobi field that
 * vanishes at the start.
 *
 * `result` is always filled; its arrays lie in `arena`, which is reset first. Returns result->status: SP_CONVERGED (length as asked),
 * SP_EDGE_REACHED (a wall of the rectangle came first: the path ends on it), SP_ITERATION_LIMIT (max_steps), SP_TOLERANCE_NOT_MET (steps
 * vanish in rounding, or are kept short by it) with the path so far; SP_SINGULAR_METRIC (the metric or grad f vanishes ahead, or at the
 * start), SP_OFF_SURFACE, SP_NOT_FINITE, SP_OUT_OF_MEMORY without. Options out of range are clamped. Cost: about 13 evaluations a step, and
 * 4 more in each with a point to write; twice that where the path ends early. */
int32_t sp_trace_path(const struct sp_surface *surface, const struct sp_trace_request *request, const struct sp_trace_options *options,
                      struct sp_arena *arena, struct sp_trace_result *result);

/* Sizes and offsets in WebAssembly, mirrored in web/runtime/layout.js; a test compares the two. */
#ifdef __wasm__
#define SP_SIZE(name, bytes) _Static_assert(sizeof(struct name) == (bytes), "mirrored in layout.js")
#define SP_AT(name, field, offset) _Static_assert(offsetof(struct name, field) == (offset), "mirrored in layout.js")
SP_SIZE(sp_surface, 56);
SP_AT(sp_surface, jet, 0);
SP_AT(sp_surface, value, 4);
SP_AT(sp_surface, kind, 8);
SP_AT(sp_surface, metric, 12);
SP_AT(sp_surface, lower, 16);
SP_AT(sp_surface, upper, 32);
SP_AT(sp_surface, extent, 48);
SP_SIZE(sp_options, 32);
SP_AT(sp_options, tolerance, 0);
SP_AT(sp_options, gradient_tolerance, 8);
SP_AT(sp_options, algorithm, 16);
SP_AT(sp_options, point_count, 20);
SP_AT(sp_options, max_iterations, 24);
SP_AT(sp_options, record, 28);
SP_SIZE(sp_request, 80);
SP_AT(sp_request, from, 0);
SP_AT(sp_request, to, 24);
SP_AT(sp_request, start, 48);
SP_AT(sp_request, start_count, 52);
SP_AT(sp_request, passage, 56);
SP_SIZE(sp_passage, 24);
SP_AT(sp_passage, way, 0);
SP_AT(sp_passage, edge, 4);
SP_AT(sp_passage, beyond, 8);
SP_AT(sp_passage, turn, 16);
SP_SIZE(sp_iterate, 32);
SP_AT(sp_iterate, energy, 0);
SP_AT(sp_iterate, gradient_norm, 8);
SP_AT(sp_iterate, decrement, 16);
SP_AT(sp_iterate, step, 24);
SP_SIZE(sp_result, 136);
SP_AT(sp_result, length, 0);
SP_AT(sp_result, length_error, 8);
SP_AT(sp_result, energy, 16);
SP_AT(sp_result, gradient_norm, 24);
SP_AT(sp_result, rounding, 32);
SP_AT(sp_result, pull, 40);
SP_AT(sp_result, points, 88);
SP_AT(sp_result, parameters, 92);
SP_AT(sp_result, history, 96);
SP_AT(sp_result, record, 100);
SP_AT(sp_result, status, 104);
SP_AT(sp_result, iterations, 108);
SP_AT(sp_result, work, 112);
SP_AT(sp_result, index, 116);
SP_AT(sp_result, touches_boundary, 120);
SP_AT(sp_result, history_count, 124);
SP_AT(sp_result, crosses_singularity, 128);
SP_SIZE(sp_trace_request, 56);
SP_AT(sp_trace_request, from, 0);
SP_AT(sp_trace_request, direction, 24);
SP_AT(sp_trace_request, length, 48);
SP_SIZE(sp_trace_options, 16);
SP_AT(sp_trace_options, tolerance, 0);
SP_AT(sp_trace_options, point_count, 8);
SP_AT(sp_trace_options, max_steps, 12);
SP_SIZE(sp_trace_result, 96);
SP_AT(sp_trace_result, length, 0);
SP_AT(sp_trace_result, length_error, 8);
SP_AT(sp_trace_result, conjugate, 16);
SP_AT(sp_trace_result, velocity, 24);
SP_AT(sp_trace_result, turn_error, 48);
SP_AT(sp_trace_result, field, 56);
SP_AT(sp_trace_result, points, 72);
SP_AT(sp_trace_result, parameters, 76);
SP_AT(sp_trace_result, status, 80);
SP_AT(sp_trace_result, steps, 84);
SP_AT(sp_trace_result, touches_boundary, 88);
SP_AT(sp_trace_result, normal, 92);
SP_SIZE(sp_arena, 12);
SP_AT(sp_arena, base, 0);
SP_AT(sp_arena, size, 4);
SP_AT(sp_arena, used, 8);
SP_SIZE(sp_mesh, 20);
SP_AT(sp_mesh, positions, 0);
SP_AT(sp_mesh, normals, 4);
SP_AT(sp_mesh, indices, 8);
SP_AT(sp_mesh, vertex_count, 12);
SP_AT(sp_mesh, triangle_count, 16);
SP_SIZE(sp_graph_options, 80);
SP_AT(sp_graph_options, box, 0);
SP_AT(sp_graph_options, cell, 48);
SP_AT(sp_graph_options, resolution, 56);
SP_AT(sp_graph_options, loose, 60);
SP_AT(sp_graph_options, reach, 64);
SP_AT(sp_graph_options, level, 72);
SP_SIZE(sp_graph, 136);
SP_AT(sp_graph, spacing, 0);
SP_AT(sp_graph, vertex_count, 36);
SP_AT(sp_graph, unique, 44);
SP_AT(sp_graph, singular, 48);
SP_AT(sp_graph, resolved, 88);
SP_AT(sp_graph, coarse, 92);
SP_AT(sp_graph, form, 96);
SP_SIZE(sp_graph_answer, 24);
SP_AT(sp_graph_answer, distance, 0);
SP_AT(sp_graph_answer, places, 8);
SP_AT(sp_graph_answer, candidate_count, 12);
SP_AT(sp_graph_answer, point_count, 16);
SP_SIZE(sp_field_request, 40);
SP_AT(sp_field_request, places, 24);
SP_AT(sp_field_request, lengths, 28);
SP_AT(sp_field_request, count, 32);
#undef SP_SIZE
#undef SP_AT
#endif

#endif
