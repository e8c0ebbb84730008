#include <cmath>

#include "sim/catalogue/effect.h"
#include "sim/dem/contact_law.h"

namespace pendular {
namespace {

/// Advances the rolling spring of each contact by one time step. Its torque M on the second grain
/// turns with the pair, grows against the rolling velocity and is limited,
///     dM = -K_r w_roll dt,  |M| <= coefficient (a/2) F_N,  K_r = K_T (a/2)^2,
/// with w_roll the relative angular velocity across the normal. Twisting about the normal meets no
/// resistance.
void roll(const dem::PairBatch& batch, const dem::PairContext& context) {
    const double coefficient = context.values["coefficient"];
    for (std::size_t k = 0; k < batch.size; ++k) {
        const double nx = batch.nx[k], ny = batch.ny[k], nz = batch.nz[k];
        const double arm = batch.diameter[k] / 2;
        double mx = batch.contact_history[0][k], my = batch.contact_history[1][k],
               mz = batch.contact_history[2][k];
        const double dt = batch.time_step;
        const double ox = batch.pair_rotation_x[k], oy = batch.pair_rotation_y[k],
                     oz = batch.pair_rotation_z[k];
        const double px = mx + dt * (oy * mz - oz * my), py = my + dt * (oz * mx - ox * mz),
                     pz = mz + dt * (ox * my - oy * mx);
        const double rx = batch.rolling_x[k], ry = batch.rolling_y[k], rz = batch.rolling_z[k];
        const double twist = rx * nx + ry * ny + rz * nz, along = px * nx + py * ny + pz * nz;
        const double stiffness = batch.stiffness[k] * arm * arm;
        mx = px - along * nx - dt * stiffness * (rx - twist * nx);
        my = py - along * ny - dt * stiffness * (ry - twist * ny);
        mz = pz - along * nz - dt * stiffness * (rz - twist * nz);
        const double limit = coefficient * arm * batch.elastic[k];
        const double squared = mx * mx + my * my + mz * mz;
        const double allowed = dem::coulomb_factor(squared, limit);
        mx *= allowed, my *= allowed, mz *= allowed;
        batch.contact_history[0][k] = mx, batch.contact_history[1][k] = my,
        batch.contact_history[2][k] = mz;
        batch.tx[k] += mx, batch.ty[k] += my, batch.tz[k] += mz;
    }
}

/// Returns the effective coefficient [1] at a given friction. Contacts slide instead of rolling
/// once sliding takes less work, so that the effective coefficient saturates as the ratio of
/// coefficient to friction grows. The factor `sliding` maximises the likelihood of the stress
/// ratios and solid fractions of the runs of the atlas.
double effective_amplitude(double coefficient, double friction) {
    constexpr double sliding = 3;
    return friction > 0 ? -friction / sliding * std::expm1(-sliding * coefficient / friction) : 0;
}

}  // namespace

/// Rough or slightly angular beads touch over a patch and resist rolling. With sliding friction
/// alone, dry beads follow one curve of stress ratio against solid fraction; with rolling
/// resistance the stress ratio is higher at the same solid fraction.
Effect rolling_resistance() {
    return {.summary = "contacts of rough grains resist rolling",
            .equation = "|M_rolling| <= coefficient (a/2) F_N",
            .parameters = {{.name = "coefficient",
                            .unit = "1",
                            .lower = 0,
                            .upper = 0.5,
                            .neutral = 0,
                            .smallest_of_interest = 0.02,
                            .meaning = "largest rolling torque of a contact, divided by (a/2) F_N "
                                       "(a: grain diameter, F_N: normal force)",
                            .effective_amplitude = effective_amplitude}},
            .change = dem::ChangePairs{.contact_history = 3, .add = roll},
            .touches = Touches::all,
            .acts_through = {"stress_ratio", "solid_fraction"},
            .references = {"Iwashita, Oda, J. Eng. Mech. 124 (1998) 285",
                           "Ai, Chen, Rotter, Ooi, Powder Technol. 206 (2011) 269, model C"}};
}

}  // namespace pendular
