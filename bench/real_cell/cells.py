"""What the cells are: dimensions, grains, walls and set points."""
import csv
import math
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
DIAMETER = 500e-6  # [m]
DENSITY = 1050  # [kg/m3]
GRAVITY = 9.81
STRESSES = (300, 1000, 3000)  # under the lid [Pa]
INERTIAL_NUMBERS = (0.02, 0.06)  # of the lid's speed over the nominal height
REPLICATES = (1, 2)
# As in bench/foreign_worlds: force of a bridge at contact.
PULL_OFF_FORCE = math.pi * DIAMETER * 20.6e-3  # [N], contact angle 0


def weight(stress):
    """Weight of a grain [a2 s22]."""
    return math.pi / 6 * DENSITY * DIAMETER * GRAVITY / stress


@dataclass(frozen=True)
class Cell:
    name: str
    wall_friction: float
    height: int  # nominal: of the free grains at solid fraction 0.6 [a]
    width: int = 24  # between the side walls [a]
    length: int = 8  # period along the flow [a]
    walls: bool = True  # False: periodic across
    friction: float = 0.12
    rolling: float = 0  # Pendular's coefficient: largest torque over (a/2) F_N
    deviation: float = 0  # of the diameters
    bridge_volume: float = 0  # of the liquid between two grains, if wet [a3]
    transient: float = 2  # strain of the nominal height before the recording begins
    strain: float = 4  # recorded after it
    stresses: tuple = STRESSES

    @property
    def grains(self):
        return round(0.6 * self.height * self.length * self.width * 6 / math.pi)


FEW = (300, 3000)  # where the stress between them tells little


def wide(wall_friction, height, stresses=STRESSES):
    name = f"walls {wall_friction:g}, height {height}"
    return Cell(name, wall_friction, height, stresses=stresses)


def narrow(wall_friction, height):
    name = f"narrow, walls {wall_friction:g}, height {height}"
    return Cell(name, wall_friction, height, width=12, length=10, transient=3, strain=5)


def wet(wall_friction):
    name = f"wet, walls {wall_friction:g}, height 12"
    return Cell(name, wall_friction, 12, bridge_volume=0.002)


# In the order in which they are simulated.
CELLS = (
    wide(0.15, 12),
    wide(0, 12),
    wide(0.15, 24, FEW),
    wide(0.3, 12),
    wide(0.05, 12),
    wide(0, 24, FEW),
    wide(0.3, 24, FEW),
    wide(0.05, 24, FEW),
    Cell("rolling, walls 0.15, height 12", 0.15, 12, friction=0.4, rolling=0.2),
    Cell("no walls, height 12", 0, 12, walls=False, stresses=FEW),
    Cell("polydisperse, walls 0.15, height 12", 0.15, 12, deviation=0.114),
    narrow(0.15, 12),
    narrow(0, 12),
    narrow(0.15, 24),
    narrow(0, 24),
    narrow(0.05, 24),
    narrow(0.3, 24),
    wet(0.15),
    wet(0),
)


def rows_of(name):
    """Rows of a table that ships."""
    with open(HERE / name, encoding="ascii") as file:
        yield from csv.DictReader(line for line in file if not line.startswith("#"))


def key_of(row):
    """Cell, set point and replicate of a row."""
    return (
        row["cell"],
        float(row["normal_stress [Pa]"]),
        float(row["inertial_number [1]"]),
        int(row["replicate"]),
    )
