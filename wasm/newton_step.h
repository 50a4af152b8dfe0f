/* One step of Newton's from a path whose equations are assembled: a direction, and how far. Knows nothing of when to stop. MATH.md,
 * "Newton". */
#ifndef SURFPATH_NEWTON_STEP_H
#define SURFPATH_NEWTON_STEP_H

#include "newton.h"

/* A change of the energy by less than this part of it is rounding; a path less steep is stationary. Why these: MATH.md, "Constants". */
static const double SP_SLACK = 1e-14, SP_STATIONARY = 1e-4;

/* What one round of Newton found out and decided. */
struct sp_round {
    struct sp_energy energy;
    struct sp_inertia inertia;
    double gradient_norm, decrement, shift;
};

static inline int sp_round_is_definite(const struct sp_round *round) { return round->inertia.usable && round->inertia.negative == 0; }

/* Puts the path moved by scale * step into `trial` and returns its sum of squares; NaN where it may not go there. */
double sp_newton_try(struct sp_newton *newton, double scale);

/* The full step of a draft of which nothing but places is needed: as sp_newton_try, but the charts stay as they are, and the energy is that
 * of the quadratic model. */
double sp_newton_try_blindly(struct sp_newton *newton, const struct sp_round *round);

/* Makes the path in `trial` the present one. */
void sp_newton_accept(struct sp_newton *newton);

/* One step of the certified method. Returns its scale, 0 if nothing lowers the energy. */
double sp_newton_step(struct sp_newton *newton, struct sp_round *round);

/* One step of the paper's method: Newton's, or its reverse where Eq. 25 fails. */
double sp_newton_step_paper(struct sp_newton *newton, struct sp_round *round);

#endif
