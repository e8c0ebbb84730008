"""Completion of words in a real shell: types the beginning of a line and a tab, and expects the
completed line.
    python3 completion.py bash|zsh|fish MANUAL
MANUAL is the folder that write_manual filled. Exit code 77: the shell is missing."""
import os, pty, re, select, shutil, sys, tempfile, time

shell, manual = sys.argv[1], os.path.abspath(sys.argv[2])
if not shutil.which(shell):
    print(f"{shell} is not installed")
    sys.exit(77)

START = {
    "bash": (["bash", "--norc", "--noprofile", "-i"], f"bind 'set enable-bracketed-paste off'; . {manual}/bash/pendular"),
    "zsh": (["zsh", "-f", "-i"], f"fpath=({manual}/zsh $fpath); autoload -U compinit; compinit -u -D"),
    "fish": (["fish", "--no-config", "-i"], f"set -p fish_complete_path {manual}/fish"),
}[shell]
# What is typed before the tab, and the line that stands there after it.
CASES = [
    ("pendular dia", "pendular diagnose"),
    ("pendular diagnose --runs", "pendular diagnose --runs-of"),
    ("pendular add beads torque-o", "pendular add beads torque-offset"),
    ("pendular simulate --torque-o", None),  # an effect of the instrument, which a run cannot have
    ("pendular simulate --rolling-resistance.co", "pendular simulate --rolling-resistance.coefficient"),
    ("pendular report beads --fidelity pap", "pendular report beads --fidelity paper"),
    ("pendular import --layout tri", "pendular import --layout trios"),
    ("pendular runs pru", "pendular runs prune"),
    ("pendular calibrate bea", "pendular calibrate beads/"),
    ("pendular import beads/dry", "pendular import beads/dry_1.csv"),
    ("pendular diagnose beads --out bea", "pendular diagnose beads --out beads/"),
]


class Terminal:
    def __init__(self, folder):
        self.pid, self.end = pty.fork()
        if self.pid == 0:
            os.chdir(folder)
            os.environ.update(TERM="xterm", PATH=f"{folder}/bin:" + os.environ["PATH"], PS1="READY> ", HOME=folder, XDG_CONFIG_HOME=folder, COLUMNS="200", LINES="50")
            os.execvp(START[0][0], START[0])
        self.type(START[1] + "\n")

    def type(self, text):
        os.write(self.end, text.encode())

    def read(self, pattern):
        """What `pattern` finds in what the terminal shows, without control sequences; None: nothing in
        20 seconds."""
        shown, deadline = "", time.time() + 20
        while time.time() < deadline:
            if select.select([self.end], [], [], 0.1)[0]:
                shown += os.read(self.end, 65536).decode(errors="replace")
            found = re.search(pattern, plain(shown), re.M)
            if found:
                return found.group(1)
        return None

    def close(self):
        self.type("\x15exit\n")
        os.close(self.end)
        os.waitpid(self.pid, 0)


def plain(text):
    text = re.sub(r"\x1b(\[[0-9;?]*[ -/]*[@-~]|\][^\x07]*\x07|[()][A-Z0-9]|[=>])", "", text)
    return re.sub(r"[\x00-\x08\x0d-\x1f]", "", text)


def completed(terminal, typed, expected):
    """Whether the line that begins with `typed` is completed to `expected` (None: not at all). The
    completed line is made the words of an echo, which shows them."""
    terminal.type("\x15" + typed + "\t")
    terminal.type("END\x01echo SHOWN: \n")  # ctrl-A: to the begin of the line
    line = terminal.read(r"^SHOWN: (.*?)[ =]*END\s*$")
    same = line == (expected or typed)
    print("ok  " if same else "FAIL", repr(typed), "->", repr(line))
    return same


with tempfile.TemporaryDirectory() as folder:
    os.makedirs(os.path.join(folder, "beads"))
    os.makedirs(os.path.join(folder, "bin"))
    # fish completes only words of programs that exist.
    os.symlink("/bin/true", os.path.join(folder, "bin/pendular"))
    for name in ("beads/study.toml", "beads/dry_1.csv"):
        open(os.path.join(folder, name), "w").close()
    terminal = Terminal(folder)
    results = [completed(terminal, *case) for case in CASES]
    terminal.close()
sys.exit(0 if all(results) else 1)
