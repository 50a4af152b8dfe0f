/* Paths that touch walls, cut into free arcs and pieces of edges. MATH.md, "Arcs". */
#ifndef SURFPATH_CONTACT_H
#define SURFPATH_CONTACT_H

#include "piece.h"

/* A path from end to end: its free arcs, and all arcs, in order. */
struct sp_contact {
    struct sp_piece pieces[SP_MAX_FREE];
    int32_t made; /* pieces; -1: they cannot be cut */
    struct sp_arcs arcs;
};

/* Cuts a path in a closed rectangle where runs of its nodes lie on walls; the pieces are still to be fitted. */
void sp_contact_cut(const struct sp_system *system, struct sp_contact *contact);

/* Slides the contacts of a piece until it is tangent to its edges, on the surface without walls: what leaves the rectangle has been cut
 * wrongly. newton->system then holds its path. `checked`: to the tolerance. Returns 0 where that fails. */
int sp_contact_fit(struct sp_newton *newton, const struct sp_options *options, int checked, struct sp_piece *piece, struct sp_arena *arena);

/* Two edges that meet in a corner: the path leaves each where this would turn by a radian on the way to the corner, about. Returns 0 where
 * an edge does not press: then no path leads along both. */
int sp_contact_cut_corner(const struct sp_surface *surface, struct sp_joint *from, struct sp_joint *to);

/* Whether a path of elements leaves the rectangle between its nodes, which do not. */
int sp_contact_leaves(const struct sp_system *system);

/* Whether a path stays in the rectangle that it was solved without. */
int sp_contact_inside(const struct sp_surface *surface, const struct sp_system *system);

/* Takes the fitted pieces into the list of arcs and lets the edge arcs begin and end where they touch. Returns 0 if an edge arc would run
 * backwards. */
int sp_contact_assemble(struct sp_contact *contact);

/* Fits all pieces and joins the arcs: `whole`, SP_ILL_CONDITIONED where one slides along its edges. Returns 0 where that fails. */
int sp_contact_solve(struct sp_newton *newton, const struct sp_options *options, struct sp_contact *contact, struct sp_arena *arena,
                     struct sp_refined *whole);

/* The surface without walls. */
struct sp_surface sp_contact_open(const struct sp_surface *surface);

/* Solves a path from a start of many nodes, newton's present one: the arcs into which those on walls cut it. Where none lies on one, what
 * it leads to without walls; and if that leaves the rectangle, the arcs into which it is cut where the start was near to a wall, or where
 * it leaves it. Then `arcs` is filled. Returns 0 where that fails, or few steps are left. */
int sp_contact_follow(struct sp_newton *newton, const struct sp_options *options, struct sp_arena *arena, struct sp_arcs *arcs,
                      struct sp_refined *whole);

/* Solves a path that touches the walls. `given`: the projected Newton's, not in newton's own arrays; `arcs` is filled. Where the arcs do
 * not fit together (a corner, a free arc that leaves the rectangle), arcs->count is 0 and newton->system the best that chords can do,
 * SP_TOLERANCE_NOT_MET if that is not enough. */
struct sp_refined sp_contact_run(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *given,
                                 struct sp_arena *arena, struct sp_arcs *arcs);

#endif
