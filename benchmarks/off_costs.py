#!/usr/bin/python3
"""What features cost where a scene does not ask for them, in instructions (callgrind).

Usage: benchmarks/off_costs.py [--check] [--build DIR] [--output DIR]

A small scene of two blocks is run under valgrind; instructions count within
Simulation::run() only. For each feature: the share of instructions in its functions
while it is off, and the ratio of all instructions when it is switched on. An interface
whose sides are far apart, and friction with a coefficient of 0, must cost next to nothing.
With --check only what must be nothing is measured, and more than the limits below is an
error (a ctest).
"""
import argparse
import os
import re
import shutil
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LIMIT = 1e-3  # share of the instructions of a run
FAR_LIMIT = 5e-3  # its facets move, and the boxes of its sides are compared
STEPS = "*solve_step*"  # all of a step but its output

SCENE = """
set Driver = contact_scene
subsection Bodies
  set Names = lower, upper
  subsection lower
    subsection Mesh
      set Cells = 4, 4, 2
    end
    subsection Material
      set Young's modulus = 1000
    end
  end
  subsection upper
    subsection Mesh
      set Lower corner = 0.2, 0.2, 1
      set Upper corner = 0.8, 0.8, 1.5
      set Cells        = 3, 3, 1
    end
    subsection Material
      set Young's modulus = 3000
    end
  end
end
subsection Boundary conditions
  set Names = base, top
  subsection base
    set Body         = lower
    set Boundary ids = 4
    set x            = 0
    set y            = 0
    set z            = 0
  end
  subsection top
    set Body         = upper
    set Boundary ids = 5
    set x            = 0.05*t
    set y            = 0
    set z            = -0.03*t
  end
end
subsection Contact
  set Interfaces = i
  subsection i
    set Secondary = lower: boundary 5
    set Primary   = upper: boundary 4
  end
end
subsection Steps
  set First step = 0.5
end
subsection Output
  set Every            = 0
  set Checkpoint every = 0
end
"""

FAR = ["Contact/Interfaces=i, far", "Contact/far/Secondary=lower: boundary 4",
       "Contact/far/Primary=upper: boundary 5"]

# name, functions, settings that switch it on (none: only the share is looked at)
FEATURES = [
    ("friction", r"[Ff]riction|prepare_slips|update_slip|store_before",
     ["Contact/i/Friction coefficient=0.3"]),
    ("ties", r"Tie[A-Z]|TiedPair", ["Contact/i/Kind=tied"]),
    ("augmentation", r"augment",
     ["Contact/i/Augmentation=Uzawa", "Contact/i/Penetration tolerance=1e-3"]),
    ("initial penetrations", r"detect_initial|depths_of",
     ["Contact/i/Initial penetration=track"]),
    ("rigid bodies", r"RigidBody|Obstacle|SmoothFacets", []),
    ("shells", r"Shell[A-Z]", []),
    ("inertia", r"::mass|Dynamics|kinetic",
     ["Dynamics/Type=dynamic", "Bodies/lower/Material/Density=1e-3",
      "Bodies/upper/Material/Density=1e-3"]),
    ("adaptive meshes", r"[Rr]efine|gradient_jumps|execute_coarsening", []),
    ("fluid", r"Fluid", []),
    ("integration by points", r"evaluate_points|add_fixed_point", ["Contact/i/Integration=points"]),
]


def count(scene, settings, label, arguments, within="Structure::Simulation<3>::run()"):
    """Instructions of a run within a function, in all and by function."""
    folder = os.path.join(arguments.output, label.replace(" ", "_"))
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, "scene.prm")
    with open(path, "w") as file:
        file.write(scene)
    out = os.path.join(folder, "callgrind.out")
    command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}",
               f"--toggle-collect={within}",
               os.path.join(arguments.build, "contact_scene"), path, "--quiet", "--output", folder]
    for setting in settings:
        command += ["--set", setting]
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    process = subprocess.run(command, env=environment, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT)
    if process.returncode != 0:
        sys.exit(process.stdout.decode(errors="replace")[-2000:])
    text = subprocess.run(["callgrind_annotate", "--threshold=100", out], stdout=subprocess.PIPE,
                          check=True).stdout.decode(errors="replace")
    functions, total = {}, 0
    for line in text.splitlines():
        match = re.match(r"\s*([\d,]+)\s*(\([\d. ]+%\))?\s+(.*)", line)
        if not match:
            continue
        n = int(match.group(1).replace(",", ""))
        if "PROGRAM TOTALS" in line:
            total = n
        else:
            functions[match.group(3)] = functions.get(match.group(3), 0) + n
    if total == 0:
        sys.exit(f"callgrind counted nothing: is {within} inlined?")
    print(f"{label}: {total / 1e6:.1f} million instructions", flush=True)
    return total, functions


def share(functions, total, pattern):
    # the function's name, not its arguments or its file
    return sum(n for name, n in functions.items()
               if re.search(pattern, name.split("[")[0].split("(")[0].split(":", 1)[-1])) / total


def main():
    options = argparse.ArgumentParser(description=__doc__,
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--check", action="store_true")
    options.add_argument("--build", default=os.path.join(ROOT, "build"))
    options.add_argument("--output", default=os.path.join(ROOT, "output", "off_costs"))
    arguments = options.parse_args()
    if not shutil.which("valgrind"):
        sys.exit("valgrind is missing: apt-get install valgrind")
    total, functions = count(SCENE, [], "all off", arguments)
    lines = ["| feature | off: share of instructions | on: instructions over all off |", "|---|---|---|"]
    wrong = []
    for name, pattern, settings in FEATURES:
        off = share(functions, total, pattern)
        if off > LIMIT:
            wrong.append(f"{name}: {off:.2e} of the instructions while it is off")
        on = ""
        if settings and not arguments.check:
            on_total, on_functions = count(SCENE, settings, name, arguments)
            on = f"{on_total / total:.3f}"
            if share(on_functions, on_total, pattern) == 0.0:
                wrong.append(f"{name}: nothing of it runs when it is on: the pattern is wrong")
        lines.append(f"| {name} | {off:.1e} | {on} |")
    in_steps, _ = count(SCENE, [], "all off, steps", arguments, STEPS)
    others = [("an interface far away, within steps", FAR, FAR_LIMIT, STEPS, in_steps)]
    if not arguments.check:
        everywhere = "Structure::Simulation<3>::run()"
        others += [
            ("friction coefficient 0", ["Contact/i/Friction coefficient=0"], LIMIT, everywhere, total),
            ("no penetration report", ["Contact/i/Penetration report every=0"], LIMIT, everywhere,
             total),
        ]
    for name, settings, limit, within, total in others:
        other, _ = count(SCENE, settings, name, arguments, within)
        lines.append(f"| {name} |  | {other / total:.4f} |")
        if abs(other / total - 1.0) > limit:
            wrong.append(f"{name}: {other / total:.4f} times the instructions")
    text = "\n".join(lines) + "\n"
    with open(os.path.join(arguments.output, "table.md"), "w") as file:
        file.write(text)
    print(text)
    for message in wrong:
        print("FAILED:", message)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
