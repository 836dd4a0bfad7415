#!/usr/bin/env python3
"""Every number that `asperity experiment` exports, computed again from the raw records; and a study
that is killed goes on to the same bytes. Usage: recompute_study.py ASPERITY
ASPERITY_TRACED"""

import csv
import filecmp
import json
import math
import pathlib
import subprocess
import sys
import tempfile

OPTIONS = ["--operators", "2", "--repeats", "2", "--seed", "7"]
TASKS = "ABC"


def rows_of(path):
    with path.open(newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def vector(row, name, unit="m"):
    return [float(row[f"{name}_{axis}_{unit}"]) for axis in "xyz"]


def distance(a, b):
    x, y, z = (p - q for p, q in zip(a, b))
    return math.sqrt((x * x + y * y) + z * z)


def counts(trial):
    return trial["fault"] == "none" and not trial["struck_out"]


def place_of(folder, trial):
    attempt = "" if trial["attempt"] == "1" else "_" + trial["attempt"]
    return folder / "trials" / f"{int(trial['trial']):03d}{attempt}"


def check_trials(folder, trials):
    for trial in trials:
        moments = rows_of(place_of(folder, trial) / "trajectory.csv")
        end = moments[-1]
        error = distance(vector(end, "tip"), vector(trial, "target"))
        assert error == float(trial["error_m"]), (trial["trial"], error)
        way = distance(vector(trial, "start"), vector(trial, "target"))
        assert 100.0 * error / way == float(trial["error_percent"])
        assert float(end["time_s"]) == float(trial["time_s"])
        assert max(float(m["largest_force_n"]) for m in moments) == float(trial["largest_force_n"])
        last = [vector(m, "device") for m in moments if float(m["time_s"]) >= float(end["time_s"]) - 0.5]
        motion = max(max(p[i] for p in last) - min(p[i] for p in last) for i in range(3))
        assert motion == float(trial["handle_motion_m"])


def incomplete_beta(a, b, x):
    """Regularized, by the continued fraction of Lentz. Source: DLMF 8.17.22."""
    if x > (a + 1.0) / (a + b + 2.0):
        return 1.0 - incomplete_beta(b, a, 1.0 - x)
    tiny = 1e-300
    front = math.exp(math.lgamma(a + b) - math.lgamma(a) - math.lgamma(b) + a * math.log(x)
                     + b * math.log1p(-x)) / a
    f, c, d = 1.0, 1.0, 0.0
    for i in range(400):
        m = i // 2
        if i == 0:
            term = 1.0
        elif i % 2 == 0:
            term = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m))
        else:
            term = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1))
        d = 1.0 / ((1.0 + term * d) or tiny)
        c = (1.0 + term / c) or tiny
        f *= c * d
        if abs(1.0 - c * d) < 1e-16:
            break
    return front * (f - 1.0)


def t_quantile(freedom):
    """Beyond which 2.5 % lie, by bisection."""
    low, high = 0.0, 1e3
    for _ in range(200):
        t = 0.5 * (low + high)
        upper = 0.5 * incomplete_beta(0.5 * freedom, 0.5, freedom / (freedom + t * t))
        low, high = (t, high) if upper > 0.025 else (low, t)
    return low


def estimate(values):
    n = len(values)
    mean = sum(values) / n
    if n < 2:
        return n, mean, math.nan, math.nan, math.nan
    deviation = math.sqrt(sum((v - mean) ** 2 for v in values) / (n - 1))
    half = t_quantile(n - 1) * deviation / math.sqrt(n)
    return n, mean, deviation, mean - half, mean + half


def by_participant(trials):
    people = {}
    for trial in trials:
        people.setdefault(int(trial["participant"]), []).append(trial)
    return [people[key] for key in sorted(people)]


def mean(values):
    values = list(values)
    return sum(values) / len(values)


def means(trials, quantity):
    return estimate([mean(float(t[quantity]) for t in own) for own in by_participant(trials)])


def slope(own, quantity):
    x = [float(t["repeat"]) for t in own]
    y = [float(t[quantity]) for t in own]
    mx, my = mean(x), mean(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)


def slopes(trials, quantity):
    return estimate([slope(own, quantity) for own in by_participant(trials)])


def deviations(trials, quantity):
    cells = {}
    for t in trials:
        cells.setdefault((t["participant"], t["material"], t["lever"]), []).append(float(t[quantity]))
    return [float(t[quantity]) - mean(cells[t["participant"], t["material"], t["lever"]])
            for t in trials]


def correlation(trials):
    x, y = deviations(trials, "time_s"), deviations(trials, "error_percent")
    mx, my = mean(x), mean(y)
    r = (sum((a - mx) * (b - my) for a, b in zip(x, y))
         / math.sqrt(sum((a - mx) ** 2 for a in x) * sum((b - my) ** 2 for b in y)))
    half = 1.959963984540054 / math.sqrt(len(x) - 3)
    return len(x), r, math.nan, math.tanh(math.atanh(r) - half), math.tanh(math.atanh(r) + half)


def close(a, b):
    return (math.isnan(a) and math.isnan(b)) or math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-12)


def expected(row, trials):
    task = [t for t in trials if t["task"] == row["task"]]
    if row["quantity"] == "share_of_faults":
        return estimate([mean(float(t["fault"] != "none") for t in own)
                         for own in by_participant(task)])
    task = [t for t in task if counts(t) and row["material"] in ("", t["material"])
            and row["lever"] in ("", t["lever"])]
    return {"error_percent": lambda: means(task, "error_percent"),
            "time_s": lambda: means(task, "time_s"),
            "error_percent_per_repeat": lambda: slopes(task, "error_percent"),
            "time_s_per_repeat": lambda: slopes(task, "time_s"),
            "correlation_of_time_and_error": lambda: correlation(task)}[row["quantity"]]()


def check_statistics(folder, trials):
    rows = rows_of(folder / "statistics.csv")
    assert len(rows) == 3 * 6 + 8 * 2, len(rows)
    for row in rows:
        own = expected(row, trials)
        stated = [float(row[key]) for key in ("count", "mean", "deviation", "low", "high")]
        assert all(close(a, b) for a, b in zip(own, stated)), (row, own)
    return rows


def paired(one, other, quantity, trials, before=None):
    """Difference of participants' means."""
    def of(chosen, all_trials):
        people = {}
        for trial in all_trials:
            if counts(trial) and chosen(trial):
                people.setdefault(int(trial["participant"]), []).append(float(trial[quantity]))
        return {key: mean(values) for key, values in people.items()}
    first, second = of(one, trials), of(other, trials if before is None else before)
    return estimate([first[key] - second[key] for key in sorted(first) if key in second])


def check_findings(folder, trials):
    def on(task, material=None):
        return lambda t: t["task"] == task and material in (None, t["material"])
    compared = [(0, on("B"), on("C"), "error_percent", "%"),
                (1, on("C"), on("A"), "error_percent", "%"),
                (3, on("B", "silicon_oxide"), on("B", "silicone_rubber"), "error_percent", "%"),
                (4, on("C", "silicone_rubber"), on("C", "polystyrene"), "error_percent", "%"),
                (5, on("C", "polystyrene"), on("C", "silicone_rubber"), "time_s", "s")]
    findings = rows_of(folder / "findings.csv")
    for number, one, other, quantity, unit in compared:
        _, value, _, low, high = paired(one, other, quantity, trials)
        verdict = "agrees" if low > 0 else "differs" if high < 0 else "open"
        assert findings[number]["verdict"] == verdict, findings[number]
        assert findings[number]["ours"] == f"difference {value:.3g} ({low:.3g} to {high:.3g}) {unit}"
    return findings


def check_summary(folder, trials, statistics, findings):
    summary = json.loads((folder / "summary.json").read_text())
    assert summary["attempts"] == len(trials)
    assert summary["counting"] == sum(map(counts, trials))
    assert summary["timed_out"] == sum(t["timed_out"] == "yes" for t in trials)
    assert sum(summary["faults"].values()) == sum(t["fault"] != "none" for t in trials)
    for stated, row in zip(summary["statistics"], statistics, strict=True):
        assert stated["quantity"] == row["quantity"] and stated["task"] == row["task"]
        assert close(stated["mean"] if stated["mean"] is not None else math.nan, float(row["mean"]))
    assert [f["ours"] for f in summary["findings"]] == [f["ours"] for f in findings]


def check_folder(folder):
    trials = rows_of(folder / "trials.csv")
    check_trials(folder, trials)
    statistics = check_statistics(folder, trials)
    findings = check_findings(folder, trials)
    check_summary(folder, trials, statistics, findings)
    return trials


def same_files(one, other):
    names = sorted(p.relative_to(one) for p in one.rglob("*") if p.is_file())
    assert names == sorted(p.relative_to(other) for p in other.rglob("*") if p.is_file())
    different = [str(n) for n in names if not filecmp.cmp(one / n, other / n, shallow=False)]
    assert not different, different


def check_killed(program, traced, scratch, whole):
    """Killed in the midst of trials; those that ended are there, and the study goes on."""
    folder = scratch / "killed"
    command = [program, "experiment", *OPTIONS, "--out", str(folder)]
    done = subprocess.run([traced, "", "trials/020", *command], check=True, text=True,
                          stdout=subprocess.PIPE)
    assert done.stdout.startswith("1 "), "it ended before it was killed"
    kept = rows_of(folder / "trials.csv")
    assert 0 < len(kept) < 32, len(kept)
    check_trials(folder, kept)
    subprocess.run([*command, "--resume"], check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)
    same_files(whole, folder)


def check_recorded(program, scratch):
    folder = scratch / "recorded"
    subprocess.run([program, "experiment", "--operators", "1", "--repeats", "1", "--record",
                    "--out", str(folder)], check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)
    for trial in sorted((folder / "trials").iterdir())[:3]:
        subprocess.run([program, "replay", str(trial), "--out", str(scratch / trial.name)],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def check_aids(program, scratch):
    folder = scratch / "aids"
    subprocess.run([program, "experiment", "--operators", "2", "--repeats", "1", "--aids", "--out",
                    str(folder)], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    rows = rows_of(folder / "aids.csv")
    variants = list(dict.fromkeys(row["variant"] for row in rows))
    assert variants == ["as_given", "no_coupling", "no_forces", "no_deformation", "point_guide"]
    before = rows_of(folder / "as_given" / "trials.csv")
    for row in rows:
        trials = rows_of(folder / row["variant"] / "trials.csv")
        is_of = lambda t, task=row["task"]: t["task"] == task
        _, value, _, low, high = paired(is_of, is_of, row["quantity"], trials, before)
        assert all(close(a, float(row[key])) for a, key in
                   ((value, "difference"), (low, "low"), (high, "high"))), row
        of = [t for t in trials if is_of(t)]
        assert close(float(row["share_of_faults"]), mean(t["fault"] != "none" for t in of))
        own = [mean(float(t[row["quantity"]]) for t in p)
               for p in by_participant([t for t in of if counts(t)])]
        assert close(float(row["mean"]), mean(own)), row


def check_recordings(folder, trials):
    """A person's moments are ticks of the trial's recording."""
    for trial in trials:
        place = place_of(folder, trial)
        ticks = {tuple(float(row[f"{of}_f{a}_n"]) for of in ("est", "device") for a in "xyz")
                 for row in rows_of(place / "force_log.csv")}
        moments = rows_of(place / "trajectory.csv")[1:]  # it begins before the recording
        assert moments
        for m in moments:
            forces = tuple(vector(m, "force", "n") + vector(m, "device_force", "n"))
            assert forces in ticks, (trial["trial"], m["time_s"])


def check_people(folder):
    """The folder of a study in the window, with as few trials as there may be."""
    trials = rows_of(folder / "trials.csv")
    check_trials(folder, trials)
    check_recordings(folder, trials)
    for row in rows_of(folder / "statistics.csv"):
        if row["quantity"] in ("error_percent", "time_s") and row["count"] != "0":
            own = expected(row, trials)
            stated = [float(row[key]) for key in ("count", "mean", "deviation", "low", "high")]
            assert all(close(a, b) for a, b in zip(own, stated)), (row, own)
    print(f"{len(trials)} trials of people computed again")


def main():
    if sys.argv[1] == "--folder":
        check_people(pathlib.Path(sys.argv[2]))
        return
    program, traced = sys.argv[1:3]
    with tempfile.TemporaryDirectory() as name:
        scratch = pathlib.Path(name)
        whole = scratch / "whole"
        subprocess.run([program, "experiment", *OPTIONS, "--out", str(whole)], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        trials = check_folder(whole)
        assert len(trials) >= 32 and {t["task"] for t in trials} == set(TASKS)
        check_killed(program, traced, scratch, whole)
        check_recorded(program, scratch)
        check_aids(program, scratch)
    print(f"{len(trials)} trials computed again")


if __name__ == "__main__":
    main()
