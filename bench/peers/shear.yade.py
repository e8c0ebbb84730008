"""Shears beads with YADE at normal stress 1: Hertz-Mindlin contacts, dry or with liquid bridges.

    yade -j1 -n -x shear.yade.py prepare gas=FILE state=FILE wet=0 ...
    yade -j1 -n -x shear.yade.py measure state=FILE end_state=FILE steps=N ...
    yade -j1 -n -x shear.yade.py sample state=FILE end_state=FILE strain=S ...
    yade -j1 -n -x shear.yade.py blocks state=FILE averages=FILE transient=S strain=S block=S ...

prepare makes a state from a gas of gas.py; measure goes on with it and prints time and means;
sample prints means of intervals of the strain S, of contacts and bridges too; blocks writes means
of blocks of strain, with the stress of velocity fluctuations (a few per mille where I > 0.01).
Lengths are in diameters, masses in bead masses, stresses in imposed normal stresses. Bridges need
the tables of bridge_tables() in the working directory.
"""
import math
import sys
import time

RATIOS = ("1", "1.1", "1.25", "1.5", "1.75", "2", "3", "4", "5", "10")
BEAD_VOLUME = math.pi / 6
RADIUS = 0.5
STEPS_BETWEEN_SERVOS = 10
PER_ROW, LOOKS_PER_ROW = 0.25, 10


def bridge_tables(volume, levels=20):
    """Tables of bridge forces as the capillary law reads them, one per ratio of radii.

    A table knows, per gap, the force at several suctions. Here it does not depend on the suction:
    F/F0 = 1 - h/sqrt(h^2 + c), c = 4 V0/(pi a), up to V0^(1/3), where the table and the bridge end.
    """
    c = 4 * volume / math.pi
    last = volume ** (1 / 3)
    for ratio in RATIOS:
        with open(f"M(r={ratio})", "w", encoding="ascii") as out:
            print(ratio, levels + 1, sep="\n", file=out)
            for level in range(levels + 1):
                gap = last * level / levels
                force = 1 - gap / math.sqrt(gap * gap + c)
                print(2, file=out)
                for suction in (0, 2):
                    print(gap / RADIUS, suction, volume / RADIUS**3, force, 30, 30, 0, 0, file=out)


def read_gas(path):
    """Box edges and centres from a LAMMPS data file."""
    with open(path, encoding="ascii") as file:
        rows = [line.split() for line in file]
    box = [float(row[1]) for row in rows if len(row) == 4 and row[2].endswith("lo")]
    return box, [[float(x) for x in row[4:]] for row in rows if len(row) == 7]


def build(gas, wet, modulus, friction, reduced_pressure, bridge_volume, time_step):
    """Beads at rest and all engines."""
    box, centres = read_gas(gas)
    O.periodic = True
    O.cell.hSize = Matrix3(box[0], 0, 0, 0, box[1], 0, 0, 0, box[2])
    O.cell.flipFlippable = True
    O.materials.append(
        FrictMat(
            young=0.91 * modulus,  # E = (1 - nu^2) E~
            poisson=0.3,
            frictionAngle=math.atan(friction),
            density=1 / BEAD_VOLUME,
        )
    )
    for centre in centres:
        O.bodies.append(sphere(centre, RADIUS))
    contact = Ip2_FrictMat_FrictMat_MindlinPhys
    bridges = []
    if wet:
        bridge_tables(bridge_volume)
        contact = Ip2_FrictMat_FrictMat_MindlinCapillaryPhys
        tension = 1 / reduced_pressure / (2 * math.pi * RADIUS)
        bridges = [
            Law2_ScGeom_CapillaryPhys_Capillarity(
                capillaryPressure=tension / RADIUS, surfaceTension=tension
            )
        ]
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=0.05, label="collider"),
        InteractionLoop(
            [Ig2_Sphere_Sphere_ScGeom()],
            [contact(betan=0.98, betas=0.0)],
            [Law2_ScGeom_MindlinPhys_Mindlin(neverErase=bool(wet))],
        ),
        *bridges,
        NewtonIntegrator(damping=0),
        PyRunner(iterPeriod=STEPS_BETWEEN_SERVOS, command="servo()", initRun=False),
    ]
    O.dt = time_step


class Flow:
    """What the servo imposes, and sums of what it sees."""

    def __init__(self, rate, wet):
        self.rate, self.wet, self.closing, self.kinetic = rate, wet, False, False
        self.restart()

    def restart(self):
        self.looks = self.normal = self.shear = self.solid = 0

    def act(self):
        stress = getStress()
        if self.wet:
            stress += getCapillaryStress(0, True)
        if self.kinetic:
            stress -= getTotalDynamicStress()  # of which YADE 2023.02a returns the negative
        normal = -stress[1, 1]
        if self.closing:
            if normal > 1:
                O.pause()
            return
        O.cell.velGrad = Matrix3(0, self.rate, 0, 0, (normal - 1) / 100, 0, 0, 0, 0)
        self.looks += 1
        self.normal += normal
        self.shear += stress[0, 1]
        self.solid += len(O.bodies) * BEAD_VOLUME / O.cell.hSize.determinant()

    def means(self):
        return self.normal / self.looks, self.shear / self.looks, self.solid / self.looks


def servo():
    """Called by the PyRunner, which is saved with the state as this name."""
    FLOW.act()


def prepare(state, wet, rate, **rest):
    """Closes the gas until it carries normal stress 1, shears it fast, then at the wanted rate."""
    build(wet=wet, **rest)
    FLOW.closing = True
    O.cell.velGrad = Matrix3(0, 0, 0, 0, -0.05, 0, 0, 0, 0)
    O.run(100_000, True)
    FLOW.closing = False
    # Bridges live a strain of order 1.
    for FLOW.rate, strain in ((10 * rate, 1.0 if wet else 0.5), (rate, 0.1)):
        O.run(math.ceil(strain / FLOW.rate / O.dt), True)
    O.save(state)


def measure(state, end_state, steps, skin):
    O.load(state)
    O.engines[1].verletDist = skin
    O.run(100, True)
    FLOW.restart()
    wall, cpu = time.perf_counter(), time.process_time()
    O.run(steps, True)
    wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
    print("means", *FLOW.means())
    print("time", wall, cpu)
    O.save(end_state)


def pairs():
    """Contacts and bridges without contact per grain (each counts for both grains), and of the
    latter: mean force over the pull-off force, and mean of n1 n2."""
    contacts = distant = force = fabric = 0
    full = O.engines[3].surfaceTension * 2 * math.pi * RADIUS
    for pair in O.interactions:
        if not pair.isReal:
            continue
        if pair.geom.penetrationDepth > 0:
            contacts += 1
        elif pair.phys.meniscus:
            distant += 1
            force += pair.phys.fCap.norm() / full
            fabric += pair.geom.normal[0] * pair.geom.normal[1]
    count = len(O.bodies)
    return 2 * contacts / count, 2 * distant / count, force / distant, fabric / distant


def sample(state, end_state, strain, skin):
    """Prints a row for each interval of PER_ROW of strain, in which pairs are counted LOOKS_PER_ROW
    times: s22, s12, solid fraction, then pairs() and capillary_stress()."""
    O.load(state)
    O.engines[1].verletDist = skin
    O.run(100, True)
    steps = round(PER_ROW / FLOW.rate / O.dt / LOOKS_PER_ROW)
    for _ in range(round(strain / PER_ROW)):
        FLOW.restart()
        looks = []
        for _ in range(LOOKS_PER_ROW):
            O.run(steps, True)
            looks.append((*pairs(), *capillary_stress()))
        means = (sum(column) / LOOKS_PER_ROW for column in zip(*looks))
        print("row", *FLOW.means(), *means)
    O.save(end_state)


def blocks(state, averages, transient, strain, block, skin):
    """Writes a line for each block: number, s22, s12, solid fraction, shear rate, 0 (bridges)."""
    O.load(state)
    O.engines[1].verletDist = skin
    FLOW.kinetic = True
    if transient > 0:  # run(0) runs for ever
        O.run(math.ceil(transient / FLOW.rate / O.dt), True)
    with open(averages, "w", encoding="ascii") as out:
        for number in range(round(strain / block)):
            FLOW.restart()
            O.run(round(block / FLOW.rate / O.dt), True)
            print(number, *FLOW.means(), FLOW.rate, 0, file=out, flush=True)


def capillary_stress():
    """s22 and s12 of the bridges' forces, compression positive, sheared as in the paper: s12 of
    the whole is negative."""
    stress = getCapillaryStress(0, True)
    return -stress[1, 1], -stress[0, 1]


def value(text):
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text


options = {key: value(text) for key, text in (word.split("=", 1) for word in sys.argv[2:])}
if sys.argv[1] == "prepare":
    FLOW = Flow(options["rate"], options["wet"])
    prepare(**options)
else:
    FLOW = Flow(options.pop("rate"), options.pop("wet"))
    {"measure": measure, "sample": sample, "blocks": blocks}[sys.argv[1]](**options)
