/* Newton's method on the energy of a polyline: the solver's heart. Knows charts and rows, not kinds of surfaces. MATH.md, "Newton". */
#ifndef SURFPATH_NEWTON_H
#define SURFPATH_NEWTON_H

#include "surfpath.h"
#include "system.h"

/* Everything Newton works on, in the caller's arena. */
struct sp_newton {
    struct sp_system system;    /* the path so far, its places filled by the start, and its equations */
    struct sp_nodes trial;      /* the path after a step, of the same size */
    sp_pair *step;              /* two numbers a pair */
    struct sp_iterate *history; /* as many entries as steps may be taken, and one; NULL while none are kept */
    double *record;             /* as many polylines of 3 (record_points + 2) numbers; NULL: not wanted, or no positions */
    int32_t history_count, record_points;
    int32_t reversed;                     /* 1: the points are recorded from the end of the path on */
    int32_t steps_left;                   /* Newton steps that may still be taken, in all runs together */
    int32_t work;                         /* as sp_result's */
    int32_t trial_touches;                /* as system.line.touches */
    int32_t short_step;                   /* 1: what its bend adds to the next step is lost in what that step leaves */
    int32_t certain;                      /* 1: the factorisation at hand also speaks for where the step in `trial` leads */
    int32_t looked;                       /* 1: so it does for the path, which is assembled no more */
    double trial_squares, trial_gradient; /* energy of `trial`; its gradient, of a plain polyline if `certain` */
    double last_decrement;                /* before the last step of a draft */
    /* 1: the step more is the last thing done, and where it leads neither assembled nor certified; of a plain polyline on a parametric
     * surface only the places are known there. */
    int32_t draft;
    double scale;     /* size of the coordinates, for rounding */
    double size;      /* the same in the unit of length, which a metric may change */
    double decrement; /* stop at this relative Newton decrement, and take one step more */
    double enough;    /* at this one without that step */
    /* End with SP_TOLERANCE_NOT_MET where 16 steps lower the energy by no more than this part of it; 0: never. */
    double least_gain;
};

/* How a run ended. */
struct sp_outcome {
    int32_t status, index, active;
    double energy, gradient_norm;
    double doubt; /* SP_ILL_CONDITIONED: by what part of its length a path may be shorter to which it could turn */
};

/* Lays out the arrays for at most `inner` unknown nodes and as many steps as the options allow. Returns 0 if the arena is full. */
int sp_newton_take(struct sp_newton *newton, const struct sp_surface *surface, const struct sp_options *options, int32_t inner,
                   struct sp_arena *arena);

/* Bytes that sp_newton_take takes. */
double sp_newton_bytes(const struct sp_surface *surface, const struct sp_options *options, int32_t inner);

/* Runs until converged or beaten, or newton->steps_left is 0, from a path whose charts are filled (sp_polyline_charts); the path is left in
 * newton->system.line and never has more energy than the start. Its steps continue the history of the run before, if there was one: see
 * sp_newton_tell_end. */
struct sp_outcome sp_newton_run(struct sp_newton *newton, const struct sp_options *options);

/* What sp_newton_run would find where a draft has just ended, without a matrix: at rest to newton->enough, as the square of the decrement
 * before its step is, and certified by the matrix of that. Returns 0 where that is not certain. */
int sp_newton_confirm(struct sp_newton *newton, struct sp_outcome *outcome);

/* Makes `end` the last entry of the history. Where the one that was last is the end of a run, the two are the same path, measured by two
 * discretisations: it is replaced, and the energies before it are multiplied by what the new measure is larger. */
void sp_newton_tell_end(struct sp_newton *newton, const struct sp_iterate *end);

#endif
