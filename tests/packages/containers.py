"""Rehearses the recipes for containers, packaging/Dockerfile and packaging/pendular.def, without Docker and
Apptainer: their steps are carried out in a clean Debian without documentation, as Debian slim has none, and
the program then calibrates an example.
    python3 containers.py PACKAGES WORK SOURCE
"""
import glob, json, os, re, shlex, shutil, subprocess, sys

packages, work, source = map(os.path.abspath, sys.argv[1:4])
here = os.path.dirname(os.path.abspath(__file__))
# What the images debian:*-slim leave out.
SLIM = "path-exclude /usr/share/doc/*\npath-include /usr/share/doc/*/copyright\npath-exclude /usr/share/man/*\n"


def shell(commands):
    """Runs commands of bash that know the functions of clean_debian.sh."""
    done = subprocess.run(["bash", "-c", f"work={shlex.quote(work)}; . {shlex.quote(here)}/clean_debian.sh; {commands}"],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        print(done.stdout[-3000:])
        sys.exit(done.returncode)
    return done.stdout


def inside(root, commands):
    return shell(f"inside {shlex.quote(root)} {shlex.quote(commands)}")


def copy(root, patterns, target):
    """Copies files that one of the patterns names."""
    files = [file for pattern in patterns for file in glob.glob(os.path.join(context, pattern))]
    assert files, f"no file is called {patterns}"
    for file in files:
        shutil.copy(file, root + target)


def dockerfile(root):
    """Carries out a Dockerfile, and returns the folder and the command with which its container starts."""
    folder, entry = "/", None
    with open(os.path.join(source, "packaging/Dockerfile"), encoding="utf-8") as file:
        lines = re.sub(r"\\\n", " ", file.read()).splitlines()
    for line in (line for line in lines if line and not line.startswith("#")):
        word, rest = line.split(None, 1)
        if word == "COPY":
            *patterns, target = rest.split()
            copy(root, patterns, target)
        elif word == "RUN":
            inside(root, f"cd {folder}; {rest}")
        elif word == "WORKDIR":
            folder = rest
            os.makedirs(root + folder, exist_ok=True)
        elif word == "ENTRYPOINT":
            entry = shlex.join(json.loads(rest))
        else:
            assert word == "FROM", f"{word} is not rehearsed"
    return folder, entry + ' "$@"'


def definition(root):
    """Carries out a definition of Apptainer, and returns the folder and the script with which its container starts."""
    with open(os.path.join(source, "packaging/pendular.def"), encoding="utf-8") as file:
        parts = re.split(r"^%(\w+)\n", re.sub(r"^#.*\n", "", file.read(), flags=re.M), flags=re.M)
    sections = dict(zip(parts[1::2], parts[2::2]))
    assert set(sections) == {"files", "post", "runscript", "test"}, f"not rehearsed: {set(sections)}"
    for line in filter(None, map(str.strip, sections["files"].splitlines())):
        copy(root, line.split()[:1], line.split()[1])
    inside(root, sections["post"])
    inside(root, sections["test"])
    return "/studies", sections["runscript"]


# The folder in which the recipes are carried out.
context = os.path.join(work, "context")
shutil.rmtree(context, ignore_errors=True)
os.makedirs(context)
package = glob.glob(os.path.join(packages, "pendular_*.deb"))[0]
shutil.copy(package, context)
shutil.copy(package, os.path.join(context, "pendular.deb"))
for recipe in (dockerfile, definition):
    root = os.path.join(work, "container")
    shell(f"clean_debian \"$release\" {shlex.quote(root)}")
    with open(root + "/etc/dpkg/dpkg.cfg.d/docker", "w", encoding="utf-8") as file:
        file.write(SLIM)
    folder, start = recipe(root)
    os.makedirs(root + folder, exist_ok=True)
    shutil.copytree(os.path.join(source, "examples/polystyrene"), root + folder + "/my-study",
                    ignore=shutil.ignore_patterns("out"))
    told = inside(root, f"cd {folder}; set -- calibrate my-study --fidelity quick --no-confirm; {start}")
    answer = next((line for line in told.splitlines() if line.startswith("Fitted: friction = ")), None)
    assert answer, told
    inside(root, f"cd {folder}; set -- compare my-study --fidelity quick; {start}")
    assert os.path.getsize(f"{root}{folder}/my-study/out/figures/calibration.png") > 1000
    size = subprocess.run(["du", "-sm", root], capture_output=True, text=True, check=True).stdout.split()[0]
    print(f"{recipe.__name__}: {size} MB; {answer}")
    shutil.rmtree(root)
