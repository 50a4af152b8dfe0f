/* A path across cuspidal edges while its crossings are being looked for: free arcs from one crossing to the next. MATH.md, "Arcs". */
#ifndef SURFPATH_BRIDGE_H
#define SURFPATH_BRIDGE_H

#include "contact.h"
#include "crossing.h"

/* Most crossings of a path. */
enum { SP_CROSSINGS = 6 };
/* Most that a crossing moves in one step, of its reach. */
static const double SP_BRIDGE_STEP = 0.5;

/* Arcs from end to end by way of the crossings; the derivatives of their length with respect to the crossings' coordinates, and an estimate
 * of the inverse of its second ones. */
struct sp_bridge {
    int32_t count; /* crossings */
    struct sp_crossing crossing[SP_CROSSINGS];
    struct sp_piece piece[SP_CROSSINGS + 1];
    struct sp_contact *beyond[2]; /* the whole of which the first, last, arc is the part from a wall to the crossing; NULL: it meets none */
    double length, slope[SP_CROSSINGS], inverse[SP_CROSSINGS][SP_CROSSINGS];
    double reach[SP_CROSSINGS]; /* how far, in its coordinate, a crossing is from the nearer end of its arcs */
    double gain;                /* what moving the crossings on would still gain */
    int learnt;                 /* the estimate is more than a first guess */
};

/* The part of a path beyond a wall that the first, last, arc of a bridge is. */
struct sp_piece *sp_bridge_beyond(const struct sp_bridge *bridge, int side);

/* Solves all arcs to the crossings, to a tolerance of the whole length where that is known. Returns 0 where one fails: then that,
 * the length and its derivatives stay as they were. */
int sp_bridge_solve(struct sp_newton *newton, const struct sp_options *options, int checked, struct sp_bridge *bridge,
                    struct sp_arena *arena);

/* Forgets what was learnt of the second derivatives: a first guess. */
void sp_bridge_start(struct sp_bridge *bridge);

/* The step downhill, no crossing by more than `most` of its reach. Returns the gain it promises; infinite while that is a guess. */
double sp_bridge_downhill(const struct sp_bridge *bridge, double most, double step[SP_CROSSINGS]);

/* Moves the crossings of a solved bridge downhill until the gain promised is below `enough` of the length; steps are halved until the
 * length falls. `spare`: room for what is tried. Returns 0 where that takes too long. */
int sp_bridge_descend(struct sp_newton *newton, const struct sp_options *options, double enough, struct sp_bridge *bridge,
                      struct sp_storage spare[SP_CROSSINGS + 1], struct sp_arena *arena);

#endif
