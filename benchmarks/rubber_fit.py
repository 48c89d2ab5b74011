#!/usr/bin/python3
"""How the rubber fit grows with the mesh.

Usage: benchmarks/rubber_fit.py [--ranks N] [--output DIR] [--whole]
         [--set "Section/Entry=value"]...

Runs benchmarks/rubber_fit_full.prm with 1/64 and 1/8 of the cells of Borrvall's
example (468 310), with --whole also with all of them, and prints a table with the time of
each part, the iterations, the peak memory of all ranks, and the exponents of time and
memory between the smallest and the largest run.
"""
import math
import os
import sys

from run_driver import ROOT, parser, run

FILE = os.path.join(ROOT, "benchmarks/rubber_fit_full.prm")
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


def main():
    options = parser(__doc__, "rubber_growth")
    options.add_argument("--whole", action="store_true")
    arguments = options.parse_args()
    os.makedirs(arguments.output, exist_ok=True)

    results = {}
    for name, cells in MESHES.items():
        if name != "1" or arguments.whole:
            settings = [f"Rubber/Cells={cells[0]}", f"Seat/Cells={cells[1]}"]
            results[name] = run("rubber_fit", FILE, name, settings, arguments)[0]
    header = ["size", "status", "dofs", "steps", "Newton", "linear per Newton", "seconds"]
    header += PARTS + ["contact share", "memory GB"]
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    for name, summary in results.items():
        times = summary["seconds"]
        wall = summary["wall_seconds"]
        contact = sum(times.get(part, 0.0) for part in PARTS if part.startswith("contact"))
        newton = summary["newton_iterations"]
        row = [name, summary["status"], summary["dofs"], summary["steps"], newton]
        row += [f"{summary['linear_iterations'] / max(1, newton):.1f}", f"{wall:.0f}"]
        row += [f"{times.get(part, 0.0):.1f}" for part in PARTS]
        row += [f"{100 * contact / wall:.0f} %", f"{summary['peak_memory_kB'] / 1e6:.2f}"]
        lines.append("| " + " | ".join(map(str, row)) + " |")
    first, last = list(results.values())[0], list(results.values())[-1]
    grown = math.log(last["dofs"] / first["dofs"])
    if any(summary["status"] != "finished" for summary in results.values()):
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
