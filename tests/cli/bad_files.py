"""Makes the files of bad_inputs.txt in the working directory."""
import json
import os
import shutil
import struct
import subprocess

GOOD = """[system]
damping = 0.1
stiffness = 1
cubic = 0.1
restitution = 0.98
[impulse]
rate = 1
law = gaussian
intensity = 0.1
"""


def write(name, contents):
    with open(name, "wb") as file:
        file.write(contents if isinstance(contents, bytes) else contents.encode())


def case_files():
    with_damping = lambda value: GOOD.replace("damping = 0.1", "damping = " + value)
    for name in ("case1", "a b", "a_b", "a", "a-budget", "a-sources", "a-order", "a_bounds"):
        write(name + ".ini", GOOD)
    files = {
        "empty": "", "binary": bytes(range(128, 256)) * 10, "huge": "# a comment\n" * 200000,
        "line": "x" * 900000, "escape": "\x1b[31m[system]\n", "unknown": "[system]\ncolour = red\n",
        "section": "[colours]\ndamping = 1\n",
        "forcing": "[system]\ndamping = 0.1\nstiffness = 1\n[forcing]\namplitude = 1\n",
        "twice": "[system]\ndamping = 1\n\ndamping = 1\n",
        "nosection": "damping = 1\n", "novalue": with_damping(""),
        "noequals": "[system]\ndamping 1\n",
        "overflow": with_damping("1e999"), "negative": GOOD.replace("= 0.98", "= -0.98"),
        "nan": with_damping("nan"),
        "comma": with_damping("0,1"), "law": GOOD.replace("gaussian", "cauchy"),
        "missing": GOOD.replace("rate = 1", ""), "longkey": "[system]\n" + "k" * 100000 + " = 1\n",
        "longvalue": with_damping("9" * 100000), "nul": with_damping("0.1\0"),
        "utf16": GOOD.encode("utf-16"),
        "twowalls": GOOD + "[wall]\nleft = 0\nleft_restitution = 1\n",
        "nowall": GOOD.replace("restitution = 0.98\n", ""),
        "halfwall": GOOD.replace("restitution = 0.98\n", "[wall]\nleft = 0\n"),
        "crossed": GOOD.replace("restitution = 0.98\n", "[wall]\nleft = 1\nleft_restitution = 1\n"
                                "right = 0\nright_restitution = 1\n"),
        "still": GOOD[:GOOD.index("[impulse]")],
    }
    for name, contents in files.items():
        write(name + ".ini", contents)
    os.symlink("loop.ini", "loop.ini")
    os.mkfifo("pipe")


def checkpoints(fpkcheck):
    subprocess.run([fpkcheck, "mcs", "case1", "--time", "2000", "--accuracy", "1", "--streams", "8",
                    "--quiet", "--checkpoint", "state"], check=True)
    with open("state", "rb") as file:
        whole = file.read()
    text = whole[:-8]
    # Format after two lines: the number of rounds; for each stream eleven words of the branch (y, y',
    # the time until the next impulse, its amplitude, the time until the next sample, the remaining
    # time, three times of noise and rest, two levels and the thresholds of the splitting), two numbers
    # of random numbers, fourteen sums of powers, nineteen other sums, and lists with their lengths.
    numbers = text.index(b"\n", text.index(b"\n") + 1) + 1

    def put(name, text):
        total = 14695981039346656037
        for byte in text:
            total = (total ^ byte) * 1099511628211 % 2**64
        write("state." + name, text + struct.pack("<Q", total))

    def number(name, place, form, value):
        at = numbers + 8 * place
        put(name, text[:at] + struct.pack("<" + form, value) + text[at + 8:])

    write("state.short", whole[:len(whole) // 2])
    write("state.flipped", whole[:5000] + bytes(b ^ 255 for b in whole[5000:5100]) + whole[5100:])
    number("rounds", 0, "Q", 2**64 - 1)
    number("far", 1, "d", 1e300)
    number("infinite", 3, "d", float("inf"))
    number("nan", 2, "d", float("nan"))
    number("counts", 14, "d", float("inf"))
    number("lists", 14 + 14 + 19, "Q", 2**63)
    put("cut", text[:numbers + 400])
    put("tail", text + b"more")


def minimal_summary(**changes):
    solution = {"id": "fd-kf", "method": "fd", "equation": "kf", "impact": "map", "options": {},
                "status": "ok", "reason": "", "seconds": 1, "moments": None, "mass": None,
                "min_density": None, "energy_residual": None}
    solution.update(changes)
    case = {"name": "case1",
            "system": {"damping": 0.1, "stiffness": 1.0, "cubic": 0.1, "restitution": 0.98},
            "impulse": {"rate": 1.0, "law": "gaussian", "intensity": 0.1, "mean": 0.0},
            "solutions": [solution], "comparisons": []}
    return {"schema": 1, "program": {"name": "fpkcheck", "version": "0", "command": "c"},
            "cases": [case]}


def summaries():
    texts = {
        "list": "[1]", "later": '{"schema": 2}', "longschema": '{"schema": "%s"}' % ("x" * 500000),
        "empty": '{"schema": 1}', "deep": "[" * 100000, "deepobject": '{"a":' * 100000,
        "overflow": '{"schema": 1e999}', "cut": '{"schema": 1, "program', "nul": '{"schema": \0',
        "binary": bytes(range(256)), "many": "[" + "[]," * 3000000 + "0]",
        "longtext": '{"schema": 1, "program": "%s"}' % ("x" * 3000000),
        "nonutf8": b'{"schema": "\xff"}',
    }
    for name, text in texts.items():
        write(name + ".json", text)

    def put(name, summary):
        write(name + ".json", json.dumps(summary))

    put("role", minimal_summary(status="\x1b[31m" + "x" * 100000))
    put("option", minimal_summary(options={"x" * 100000: 1}))
    put("optionrange", minimal_summary(options={"order": 2**40}))
    put("method", minimal_summary(method="magic"))
    put("beyond", minimal_summary(options={"order": 2**64 - 1}))
    put("wrongtypes", minimal_summary(seconds="long"))
    none = minimal_summary()
    none["cases"] = []
    put("nocases", none)
    none = minimal_summary()
    none["cases"][0]["solutions"] = []
    put("emptylists", none)
    none = minimal_summary()
    del none["cases"][0]["name"]
    put("nobody", none)
    twice = minimal_summary()
    twice["cases"] *= 2
    put("twice", twice)


def classic_netcdf(length):
    """A file in the format CDF-5 with a variable of `length` values, without the values."""
    name = lambda text: struct.pack(">Q", len(text)) + text + b"\0" * (-len(text) % 4)
    dimensions = struct.pack(">IQ", 10, 1) + name(b"solution") + struct.pack(">Q", length)
    variable = name(b"p_case1") + struct.pack(">QQ", 1, 0) + struct.pack(">IQ", 0, 0)
    variable += struct.pack(">IQQ", 6, length * 8, 200)
    return (b"CDF\x05" + struct.pack(">Q", 0) + dimensions + struct.pack(">IQ", 0, 0) +
            struct.pack(">IQ", 11, 1) + variable)


def runs(fpkcheck):
    # A small grid suffices: the tests need a complete run, not an accurate one.
    subprocess.run([fpkcheck, "fd", "case1", "--nx", "40", "--nv", "40", "--y-max", "5", "--v-max",
                    "5", "--quiet", "--out", "run"], stderr=subprocess.DEVNULL)
    read = lambda name: open("run/" + name, "rb").read()
    # Without checksums in the summary, damaged files pass the first test of the reader.
    shutil.copytree("run", "run.changed")
    write("run.changed/marginals.csv", read("marginals.csv").replace(b"1", b"2"))
    whole = json.loads(read("summary.json"))
    del whole["files"]
    write("run/summary.json", json.dumps(whole).encode())
    marginals, joint, summary = read("marginals.csv"), read("joint.nc"), read("summary.json")
    lines = marginals.split(b"\n")

    def with_line(line):
        return b"\n".join(lines[:5] + [line] + lines[6:])

    def run(name, file, contents):
        shutil.copytree("run", "run." + name)
        if os.path.exists(f"run.{name}/{file}"):
            os.remove(f"run.{name}/{file}")
        if contents == "pipe":
            os.mkfifo(f"run.{name}/{file}")
        elif contents == "directory":
            os.mkdir(f"run.{name}/{file}")
        elif contents is not None:
            write(f"run.{name}/{file}", contents)

    run("nomarginals", "marginals.csv", None)
    run("othermarginals", "marginals.csv", marginals.replace(b"fd-kf", b"fd-km4"))
    run("header", "marginals.csv", b"a,b,c\n")
    run("fields", "marginals.csv", with_line(b"case1,fd-kf"))
    run("variable", "marginals.csv", with_line(b"case1,fd-kf,z,1,2,,"))
    run("number", "marginals.csv", with_line(b"case1,fd-kf,y,1e999,2,,"))
    run("infinite", "marginals.csv", with_line(b"case1,fd-kf,y,1,inf,,"))
    run("nan", "marginals.csv", with_line(b"case1,fd-kf,y,nan,2,,"))
    run("words", "marginals.csv", with_line(b"case1,fd-kf,y,one,2,,"))
    run("escape", "marginals.csv", with_line(b"case1,fd-kf,y,\x1b[31m,2,,"))
    run("longline", "marginals.csv", with_line(b"x" * 1000000))
    run("pipe", "marginals.csv", "pipe")
    run("directory", "marginals.csv", "directory")
    run("smooth", "smooth.csv", b"a,b\n")
    run("deep", "summary.json", b"[" * 100000)
    run("cut", "summary.json", summary[:1000])
    run("empty", "summary.json", b"")
    run("name", "summary.json", summary.replace(b'"case1"', b'"\\u001b[31m"'))
    run("longname", "summary.json", summary.replace(b'"case1"', b'"' + b"x" * 100000 + b'"'))
    half = len(joint) // 2
    run("joint.empty", "joint.nc", b"")
    run("joint.text", "joint.nc", b"not netCDF")
    run("joint.cut", "joint.nc", joint[:half])
    run("joint.flipped", "joint.nc", joint[:64] + b"\xff" * 4000 + joint[4064:])
    run("joint.classic", "joint.nc", classic_netcdf(4))
    run("joint.classichuge", "joint.nc", classic_netcdf(2**40))
    run("joint.pipe", "joint.nc", "pipe")
    run("joint.directory", "joint.nc", "directory")
    subprocess.run([fpkcheck, "fd", "case2", "--nx", "40", "--nv", "40", "--y-max", "8", "--v-max",
                    "8", "--quiet", "--out", "other"], stderr=subprocess.DEVNULL)
    with open("other/joint.nc", "rb") as file:
        run("joint.other", "joint.nc", file.read())


def tables():
    rows = lambda *lines: "\n".join(lines) + "\n"
    files = {
        "y": rows("y,density", "0,1", "1,1", "2,1", "3,0.1"),
        "fd_kf": rows("y,density", "0,1", "1,1", "2,1", "3,0.1"),
        "v": rows("-1,1", "0,1", "1,1", "3,0.1"), "empty": "", "words": "a b\nc d\n",
        "onecolumn": rows("1", "2", "3", "4"), "fourcolumns": rows("1,2,3,4", "2,3,4,5"),
        "ragged": rows("0,1", "1,1", "2", "3,1"), "short": rows("0,1", "1,1"),
        "falling": rows("0,1", "2,1", "1,1", "3,1"), "equal": rows("0,1", "1,1", "1,1", "3,1"),
        "ulp": rows("0 1", "0.30000000000000004 2", "0.3 3", "3 1"),
        "mixed": rows("0,1", "1,1", "2;1", "3,1"), "tabs": rows("0 1", "1\t1", "2 1", "3 1"),
        "decimal": rows("0,1;1,0", "1,5;1,0", "2,1;1,0", "3,1;1,0"),
        "infinite": rows("0,1", "1,inf", "2,1", "3,1"), "nan": rows("0,1", "1,nan", "2,1", "3,1"),
        "overflow": rows("0,1", "1,1e999", "2,1", "3,1"),
        "negative": rows("0,1", "1,-1", "2,1", "3,1"),
        "negativey": rows("y,density", "-1,1", "1,1", "2,1", "3,1"),
        "zero": rows("0,0", "1,0", "2,0", "3,0"),
        "counts": rows("lower,upper,count", "0,1,1e308", "1,2,1e308", "2,3,1e308", "3,4,1e308"),
        "counts2": rows("lower,upper,count", "0,1,1e308", "1,2,1", "2,3,1", "3,4,1"),
        "gap": rows("lower,upper,count", "0,1,1", "1,2,1", "2.5,3,1", "3,4,1"),
        "overlap": rows("lower,upper,count", "0,1,1", "0.5,2,1", "2,3,1", "3,4,1"),
        "binary": bytes(range(128, 256)) * 10, "escape": rows("0,1", "1,\x1b[31m", "2,1", "3,1"),
        "longline": "1" * 1000000 + ",2\n", "longfield": rows("0,1", "1," + "x" * 9000),
        "rows": "".join(f"{k} 1\n" for k in range(100002)),
        "huge": "# comment\n" * 3500000, "names": rows("a,b,c", "0,1", "1,1", "2,1", "3,1"),
    }
    grid = [f"{y},{v},1" for y in range(4) for v in range(-2, 3)]
    files |= {
        "grid": rows("y,v,p", *grid), "hole": rows("y,v,p", *grid[:-1]),
        "again": rows("y,v,p", *grid, "0,0,1"), "thin": rows("y,v,p", *grid[:15]),
        "behind": rows("v,y,p", *grid), "empty_grid": rows("y,v,p", *(g[:-1] + "0" for g in grid)),
        "spread": rows("y,v,p", *(f"{k},{k},1" for k in range(5000))),
        "gridrows": "y,v,p\n" + "".join(f"{k},1,1\n" for k in range(1000002)),
        "nul": b"y,v,p\n0,0,\0\n",
    }
    for name, contents in files.items():
        write(name + ".csv", contents)


def forms():
    good = {"coordinates": "y,v", "coefficients": [{"x1": 2, "x2": 0, "a": -1},
                                                   {"x1": 0, "x2": 2, "a": -1}]}
    box = {"support": {"y_max": 6, "v_max": 6}}
    files = {
        "form": good, "norm": good | box, "nocoordinates": {"coefficients": []},
        "coordinates": good | {"coordinates": "\x1b[31m"}, "constant": good | {"C": 0},
        "power": good | {"coefficients": [{"x1": 1e9, "x2": 0, "a": -1}]},
        "nopower": good | {"coefficients": [{"x2": 0, "a": -1}]},
        "steep": good | box | {"coefficients": [{"x1": 40, "x2": 0, "a": 1e9}]},
        "half": good | {"support": {"y_max": 6}}, "polar": good | box | {"coordinates": "amplitude,phase"},
        "dots": good | {"a.b": 1},
    }
    for name, contents in files.items():
        write("form-" + name + ".json", json.dumps(contents))
    summary = minimal_summary()
    summary["cases"][0]["solutions"][0].update(good)
    write("form-summary.json", json.dumps(summary))
    write("form-nobody.json", json.dumps(minimal_summary()))
    write("classic.nc", classic_netcdf(4))
    write("cut.nc", b"\x89HDF\r\n\x1a\n" + b"x" * 1000)
    write("three.csv", "0 0 1\n1 1 1\n")


def plans():
    vary = "[vary]\nsystem.restitution = 0.9,1\n"
    for name, text in {
        "both": "[sweep]\ncase = case1\n[system]\ndamping = 1\n" + vary,
        "design": "[sweep]\ncase = case1\ndesign = all\n" + vary,
        "points": "[sweep]\ncase = case1\npoints = 1e9\n" + vary,
        "key": "[sweep]\ncase = case1\nthreads = 3\n" + vary,
        "option": "[sweep]\ncase = case1\nmax_seconds = soon\n" + vary,
        "nothing": "[sweep]\ncase = case1\n",
        "case": "[sweep]\ncase = case9\n" + vary,
        "twice": "[sweep]\ncase = case1\ncase = case2\n" + vary,
        "incomplete": "[sweep]\n[system]\ndamping = 1\n" + vary,
        "vary": "[sweep]\ncase = case1\n[vary]\nsystem.restitution = 0.9:2:3\n",
    }.items():
        write(f"plan-{name}.ini", text)
    # Invalid files in place of the journal of a sweep.
    for name, journal in {"words": "hello\n", "binary": bytes(range(128, 256)) + b"\n",
                          "empty-line": "\n", "later": "00000000 {}\n",
                          "deep": "12345678 " + "[" * 100000 + "\n"}.items():
        os.mkdir(f"journal.{name}")
        write(f"journal.{name}/journal", journal)
    os.mkdir("journal.pipe")
    os.mkfifo("journal.pipe/journal")
    os.mkdir("journal.link")
    os.symlink("../case1.ini", "journal.link/journal")
    os.makedirs("journal.directory/journal")


def make(fpkcheck):
    plans()
    case_files()
    summaries()
    tables()
    forms()
    checkpoints(fpkcheck)
    runs(fpkcheck)
