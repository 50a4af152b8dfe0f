/* One step of the Runge-Kutta method DOP853 of order 8 for an autonomous system y' = f(y), with two error estimates and a polynomial of
 * order 7 in between: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer 1993, II.5 and II.6.
 *
 * Knows neither tolerances nor what the numbers mean: trace.c decides. All its memory is the caller's. */
#ifndef SURFPATH_DOP853_H
#define SURFPATH_DOP853_H

/* Numbers of a state, those that an equation does not need being 0; slopes of a step: 12 of the step itself, 4 more of its polynomial. */
enum { SP_STATE = 10, SP_STAGES = 16 };

/* An ordinary differential equation: writes the slope f(y) of a state y. Where f is not defined it is NaN. */
struct sp_ode {
    void (*slope)(const void *context, const double *state, double *slope);
    const void *context;
};

struct sp_stages {
    double slope[SP_STAGES][SP_STATE];
};

struct sp_dense {
    double coefficients[8][SP_STATE];
};

/* Writes the state after a step of length h. The caller has put the slope at `state` into stages->slope[0]; 11 evaluations write the next
 * eleven. */
void sp_dop853_step(const struct sp_ode *ode, const double *state, double h, struct sp_stages *stages, double *next);

/* Differences, over h, to embedded results of order 5 and 3. The estimate of the error is h |fifth|^2 / sqrt(|fifth|^2 + |third|^2/100):
 * it falls like h^8, in whichever norm the caller chooses. */
void sp_dop853_errors(const struct sp_stages *stages, double *fifth, double *third);

/* Prepares the polynomial of an accepted step, with 4 evaluations more. The stages are spoilt by it. */
void sp_dop853_dense(const struct sp_ode *ode, const double *state, double h, struct sp_stages *stages, const double *next,
                     struct sp_dense *dense);

/* Writes the state at a fraction of the step, 0 … 1; at both ends it is that of the step to rounding. */
void sp_dop853_between(const struct sp_dense *dense, double fraction, double *state);

#endif
