/* Which kind a surface is of: the one list of all kinds. */
#include "chart.h"

const struct sp_kind *sp_kind_of(const struct sp_surface *surface) {
    static const struct sp_kind *const KINDS[][6] = {
        {&sp_parametric_kind, &sp_parametric_density_kind, &sp_parametric_tensor_kind, &sp_polar_kind, &sp_polar_density_kind,
         &sp_polar_tensor_kind},
        {&sp_implicit_kind, &sp_implicit_density_kind, &sp_implicit_tensor_kind},
    };
    return KINDS[surface->kind == SP_IMPLICIT][surface->metric];
}
