#!/usr/bin/python3
"""How the rubber fit grows with the mesh.

Usage: benchmarks/rubber_fit.py [--ranks N] [--output DIR] [--whole]
         [--set "Section/Entry=value"]...

Runs prm/rubber_fit.prm with 1/64 and 1/8 of the cells of Borrvall's example
(468 310), with --whole also with all of them, and prints a table with the time of
each part, the iterations, the peak memory of all ranks, and the exponents of time and
memory between the smallest and the largest run.
"""
import argparse
import json
import math
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
MESHES = {
    "1/64": ("30, 9, 24", "18, 3, 13"),
    "1/8": ("60, 19, 48", "36, 5, 26"),
    "1": ("120, 37, 97", "71, 10, 53"),
}
PARTS = [
    "setup",
    "matrix pattern",
    "assembly: cells",
    "contact: search and evaluation",
    "contact: assembly",
    "linear solver",
    "output",
]


def run(name, cells, arguments):
    folder = os.path.join(arguments.output, name.replace("/", "_"))
    command = ["mpirun", "-np", str(arguments.ranks)]
    command += [os.path.join(arguments.build, "rubber_fit")]
    command += [os.path.join(ROOT, "prm/rubber_fit.prm"), "--quiet", "--output", folder]
    settings = [f"Rubber/Cells={cells[0]}", f"Seat/Cells={cells[1]}"]
    settings += ["Output/Every=5", "Solver/Linear/Type=iterative"]
    settings += ["Steps/First step=0.025"]
    for setting in settings + arguments.set:
        command += ["--set", setting]
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    environment.setdefault("OMPI_ALLOW_RUN_AS_ROOT", "1")
    environment.setdefault("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1")
    code = subprocess.run(command, env=environment).returncode
    if code not in (0, 2):
        sys.exit(f"{name}: exit code {code}: {' '.join(command)}")
    with open(os.path.join(folder, "summary.json")) as file:
        summary = json.load(file)
    return summary, summary["seconds"]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--build", default=os.path.join(ROOT, "build"))
    parser.add_argument("--output", default=os.path.join(ROOT, "output/rubber_growth"))
    parser.add_argument("--ranks", type=int, default=2)
    parser.add_argument("--whole", action="store_true")
    parser.add_argument("--set", action="append", default=[])
    arguments = parser.parse_args()
    os.makedirs(arguments.output, exist_ok=True)

    results = {}
    for name, cells in MESHES.items():
        if name != "1" or arguments.whole:
            results[name] = run(name, cells, arguments)
    header = ["size", "status", "dofs", "steps", "Newton", "linear per Newton", "seconds"]
    header += PARTS + ["contact share", "memory GB"]
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    for name, (summary, times) in results.items():
        wall = summary["wall_seconds"]
        contact = sum(times.get(part, 0.0) for part in PARTS if part.startswith("contact"))
        newton = summary["newton_iterations"]
        row = [name, summary["status"], summary["dofs"], summary["steps"], newton]
        row += [f"{summary['linear_iterations'] / max(1, newton):.1f}", f"{wall:.0f}"]
        row += [f"{times.get(part, 0.0):.1f}" for part in PARTS]
        row += [f"{100 * contact / wall:.0f} %", f"{summary['peak_memory_kB'] / 1e6:.2f}"]
        lines.append("| " + " | ".join(map(str, row)) + " |")
    first, last = list(results.values())[0][0], list(results.values())[-1][0]
    grown = math.log(last["dofs"] / first["dofs"])
    if any(summary["status"] != "finished" for summary, _ in results.values()):
        sys.exit("\n".join(lines) + "\nNot all runs finished: no exponents.")
    lines += ["", "Exponents over the number of dofs: time "
              f"{math.log(last['wall_seconds'] / first['wall_seconds']) / grown:.2f}, memory "
              f"{math.log(last['peak_memory_kB'] / first['peak_memory_kB']) / grown:.2f}; "
              f"{arguments.ranks} ranks."]
    text = "\n".join(lines) + "\n"
    with open(os.path.join(arguments.output, "table.md"), "w") as file:
        file.write(text)
    print(text)


if __name__ == "__main__":
    main()
