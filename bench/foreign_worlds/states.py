"""What the foreign worlds are: grains, liquid and set points of the benchmark's rig."""
import math
from dataclasses import dataclass

# bench/hidden_effects/rig.cpp and sim/lab/lab_plan.h
DIAMETER = 500e-6  # [m]
PULL_OFF_FORCE = math.pi * DIAMETER * 20.6e-3  # [N], contact angle 0
DRY_STRESSES = (280, 900, 3200)  # [Pa]
WET_STRESSES = (280, 1800)
INERTIAL_NUMBERS = (0.045, 0.013)
CONTENTS = (0.006, 0.014, 0.03)

# V0/a^3 [1e-3] at which Pendular's simulations of the same rig (stiffness number 1500) have these
# liquid contents. The table says which contents come out.
HYSTERETIC = {
    (280, 0.013): (0.895, 2.00, 4.10),
    (1800, 0.013): (0.864, 1.925, 3.94),
    (280, 0.045): (0.905, 2.02, 4.14),
    (1800, 0.045): (0.883, 1.963, 4.01),
}
REVERSIBLE = {
    (280, 0.013): (0.808, 1.785, 3.60),
    (1800, 0.013): (0.787, 1.735, 3.51),
    (280, 0.045): (0.819, 1.805, 3.64),
    (1800, 0.045): (0.800, 1.760, 3.56),
}


@dataclass(frozen=True)
class World:
    name: str
    friction: float = 0.11
    rolling: float = 0  # Pendular's coefficient: largest torque over (a/2) F_N
    adhesion: float = 0  # [N], of dry contacts
    deviation: float = 0  # of diameters
    bridges: str = ""  # a law of cohesion.cpp: wet readings; none: dry readings
    closed: float = 0.6  # solid fraction at which shear begins
    code: str = "lammps"  # "yade": dry grains without adhesion, rolling resistance or deviation

    @property
    def contents(self):
        return CONTENTS if self.bridges else (0,)

    def bridge_volume(self, normal_stress, inertial_number, content):
        volumes = REVERSIBLE if self.bridges == "reversible" else HYSTERETIC
        return 1e-3 * volumes[normal_stress, inertial_number][CONTENTS.index(content)]


# Adhesion and deviation are those of the benchmark's truths at v = 60.
WORLDS = (
    World("plain"),
    World("rolling", friction=0.4, rolling=0.2, closed=0.53),
    World("adhesion", adhesion=1.14e-5),
    World("polydispersity", deviation=0.114),
    World("wet", bridges="capillary", closed=0.58),
    World("wet-reversible", bridges="reversible", closed=0.58),
    World("wet-constant", bridges="constant", closed=0.58),
    World("plain-yade", code="yade"),
)
