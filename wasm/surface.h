/* The contract of a compiled surface: two function pointers and the layout of what they read and write.
 *
 * A surface in the browser is a generated WebAssembly module, in a native test a C function of the same type. Points are handed over in
 * pairs (see pair.h): number j of the two points of pair k stands at data[stride * k + j] of an array of sp_pair, so that everything about
 * a pair is contiguous and nothing is a large power of two apart. */
#ifndef SURFPATH_SURFACE_H
#define SURFPATH_SURFACE_H

#include "pair.h"

/* Evaluates `pair_count` pairs of points. `in` and `out` do not overlap and are aligned to 16 bytes. Never fails: outside the domain of an
 * expression the numbers are NaN or infinite. */
typedef void (*sp_evaluate)(int32_t pair_count, const sp_pair *in, sp_pair *out);

/* What the places of a surface are: u v in a rectangle, or x y z on f = 0. */
enum sp_surface_kind { SP_PARAMETRIC = 0, SP_IMPLICIT = 1 };

/* How length is measured: as space does; times a density; by a tensor over the places instead. */
enum sp_surface_metric { SP_INDUCED = 0, SP_DENSITY = 1, SP_TENSOR = 2 };

/* Parametric S(u,v): what `jet` and `value` read and write, per pair. */
enum {
    SP_PARAMETRIC_INPUTS = 2, /* u v */
    SP_PARAMETRIC_VALUES = 3, /* x y z */
    SP_PARAMETRIC_JET = 18    /* x y z, then the same three of S_u, S_v, S_uu, S_uv, S_vv */
};

/* Implicit f(x,y,z) = 0. */
enum {
    SP_IMPLICIT_INPUTS = 3, /* x y z */
    SP_IMPLICIT_VALUES = 4, /* f, f_x f_y f_z */
    SP_IMPLICIT_JET = 10    /* f, f_x f_y f_z, f_xx f_xy f_xz f_yy f_yz f_zz */
};

/* What `jet` writes instead where there is a density or a tensor; `value` stays what it is. The length element is sqrt(phi) ds, of a
 * density phi = rho |rho|; or sqrt(dq' T dq), with a density T = rho |rho| tensor. */
enum {
    SP_PARAMETRIC_DENSITY_JET = 24, /* x y z phi, then the same four of the derivatives by u, v, uu, uv, vv */
    SP_PARAMETRIC_TENSOR_JET = 18,  /* E F G, then the same three of those derivatives */
    SP_IMPLICIT_DENSITY_JET = 20,   /* f phi, then the same two of the derivatives by x, y, z, xx, xy, xz, yy, yz, zz */
    SP_IMPLICIT_TENSOR_JET = 70     /* f, T_xx T_xy T_yy T_xz T_yz T_zz, then the same seven of those derivatives */
};

/* A surface as the solver sees it. */
struct sp_surface {
    sp_evaluate jet;   /* values, first and second derivatives */
    sp_evaluate value; /* values (implicit: and the gradient): cheaper; NULL: parametric, without positions */
    int32_t kind;      /* enum sp_surface_kind */
    int32_t metric;    /* enum sp_surface_metric */
    double lower[2];   /* parametric: closed rectangle of u and v; -inf and +inf in a direction without walls */
    double upper[2];
    double extent; /* implicit: diagonal of the box in which the surface is searched; 0: not known */
};

#endif
