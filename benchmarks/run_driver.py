"""Runs of a driver for the benchmarks of this folder."""
import argparse
import json
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def parser(description, output):
    """Options that all benchmarks share."""
    result = argparse.ArgumentParser(
        description=description, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    result.add_argument("--build", default=os.path.join(ROOT, "build"))
    result.add_argument("--output", default=os.path.join(ROOT, "output", output))
    result.add_argument("--ranks", type=int, default=2)
    result.add_argument("--set", action="append", default=[])
    return result


def run(driver, file, name, settings, arguments):
    """One run of a driver; arguments.set comes before the settings.

    Returns its summary and its folder; ends the program if the driver failed (a run
    that did not converge has not failed)."""
    folder = os.path.join(arguments.output, name.replace(" ", "_").replace("/", "_"))
    command = ["mpirun", "-np", str(arguments.ranks)]
    command += [os.path.join(arguments.build, driver), file, "--quiet", "--output", folder]
    for setting in arguments.set + settings:
        command += ["--set", setting]
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    environment.setdefault("OMPI_ALLOW_RUN_AS_ROOT", "1")
    environment.setdefault("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1")
    code = subprocess.run(command, env=environment, stdout=subprocess.DEVNULL).returncode
    if code not in (0, 2):
        sys.exit(f"{name}: exit code {code}: {' '.join(command)}")
    with open(os.path.join(folder, "summary.json")) as file:
        summary = json.load(file)
    print(
        f"{name}: {summary['status']}, {summary['newton_iterations']} iterations, "
        f"{summary['cut_backs']} cut-backs, {summary['wall_seconds']:.1f} s",
        flush=True,
    )
    return summary, folder
