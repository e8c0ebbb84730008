"""Profile of a bed that is sheared under its lid between side walls: balance of forces of slices, with
the nonlocal fluidity of Kamrin and Koval (Phys. Rev. Lett. 108 (2012) 178301). docs/explanation/cell.md
derives it. Reduced units: diameter, grain mass and normal stress under the lid are 1.
"""
import math

SLOPE = 0.93  # d(stress ratio)/dI of homogeneous flow, friction 0.12, I = 0 to 0.1 (pendular predict)
QUASI_STATIC = 0.2755  # stress ratio of homogeneous flow at I -> 0, by the same line
LATERAL = 0.85  # normal stress on the side walls over that on horizontal planes


def solve_rows(below, middle, above, right):
    """Thomas' algorithm for a tridiagonal system."""
    n = len(middle)
    c, d = [0.0] * n, [0.0] * n
    c[0], d[0] = above[0] / middle[0], right[0] / middle[0]
    for k in range(1, n):
        pivot = middle[k] - below[k] * c[k - 1]
        c[k] = above[k] / pivot
        d[k] = (right[k] - below[k] * d[k - 1]) / pivot
    for k in range(n - 2, -1, -1):
        d[k] -= c[k] * d[k + 1]
    return d


def rates(ratio, pressure, reach, step, slope=SLOPE, quasi_static=QUASI_STATIC):
    """Shear rates at the middle of slices: g'' = (g - g_local) |ratio - quasi_static|/reach^2 with the
    fluidity g = rate/ratio, no gradient at lid and base."""
    n = len(ratio)
    below, middle, above, right = ([0.0] * n for _ in range(4))
    for k in range(n):
        excess = ratio[k] - quasi_static
        local = max(0.0, excess) * math.sqrt(pressure[k]) / (slope * ratio[k])
        weight = max(abs(excess), 1e-6) * (step / reach) ** 2
        below[k] = 1.0 if k > 0 else 0.0
        above[k] = 1.0 if k < n - 1 else 0.0
        middle[k] = -(below[k] + above[k]) - weight
        right[k] = -weight * local
    fluidity = solve_rows(below, middle, above, right)
    return [g * m for g, m in zip(fluidity, ratio)]


def profile(height, width, wall_friction, weight, speed, reach=0.4, slices=120, **material):
    """Stress ratio under the lid, and lists by slice from the lid on: depth, stress ratio, rate.
    `weight`: of the bed per area over the load."""
    step = height / slices
    depth = [(k + 0.5) * step for k in range(slices)]
    pressure = [1 + weight * d / height for d in depth]

    def ratios(at_lid):
        # tau' = -2 wall friction * lateral stress/width
        result = []
        for d, p in zip(depth, pressure):
            drag = 2 * wall_friction * LATERAL * d * (1 + weight * d / height / 2) / width
            result.append((at_lid - drag) / p)
        return result

    def velocity(at_lid):
        ratio = [max(m, 1e-3) for m in ratios(at_lid)]
        return ratio, rates(ratio, pressure, reach, step, **material)

    low, high = 0.2, 1.5
    for _ in range(60):
        middle = 0.5 * (low + high)
        if sum(velocity(middle)[1]) * step < speed:
            low = middle
        else:
            high = middle
    ratio, rate = velocity(high)
    return high, depth, ratio, rate


def sheared_height(rate, step):
    """V^2/integral of rate^2: the height of the bed if the rate is uniform, less where it is not."""
    return sum(rate) ** 2 * step / sum(r * r for r in rate)


def sliding_friction(wall_friction):
    """Friction stress over normal stress of grains of friction 0.12 that slide along a wall much faster
    than they fluctuate: they roll before they slide on walls rougher than about 0.19."""
    return wall_friction / (1 + (wall_friction / 0.187) ** 3.1) ** (1 / 3.1)


def sliding_length(inertial_number):
    """Velocity over shear rate, in diameters, at which fluctuations cancel a quarter of the friction."""
    return 3.8 * (min(max(inertial_number, 0.001), 0.15) / 0.03) ** -0.16


def mobilised_share(velocity_over_rate, inertial_number):
    """Share of it that acts along the flow, as sim/effects/wall_mobilisation.h has it: constants of both
    from layers of the cells 24 wide and 12 high, walls 0.05, 0.15, 0.3, first samples."""
    return math.tanh(velocity_over_rate / sliding_length(inertial_number))
