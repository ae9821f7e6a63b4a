"""The verb trace without a browser: who is answered, what is written, what a page is made of."""
import contextlib
import http.client
import json
import re
import signal
import socket
import subprocess
import threading
import time
import urllib.parse

import pytest


def heed_hangups():
    """Whoever started these tests with nohup ignores hangups, and so would the program, on purpose."""
    signal.signal(signal.SIGHUP, signal.SIG_DFL)


def start(program, *arguments):
    """The verb and the address that it prints."""
    process = subprocess.Popen(
        [str(program), "trace", *map(str, arguments)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=heed_hangups,
    )
    address = process.stdout.readline().strip()
    assert re.fullmatch(r"http://127\.0\.0\.1:\d+/[0-9a-f]{32}/", address), process.stderr.read()
    return process, address


@contextlib.contextmanager
def served(program, *arguments):
    """The verb as it answers, its page loaded; ends it as a person does, by Ctrl-C."""
    process, address = start(program, *arguments)
    try:
        assert ask(address)[0] == 200
        yield address
    finally:
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        assert process.returncode == 0


def ask(address, method="GET", path="", body=None, **headers):
    url = urllib.parse.urlsplit(address)
    connection = http.client.HTTPConnection(url.hostname, url.port, timeout=120)
    own = {"Host": url.netloc}
    if method == "POST":
        own.update({"Origin": f"http://{url.netloc}", "Content-Type": "application/json"})
    own.update({name.replace("_", "-"): value for name, value in headers.items()})
    connection.request(method, path if path.startswith("/") else url.path + path, body, own)
    answer = connection.getresponse()
    text = answer.read().decode()
    connection.close()
    return answer.status, text


@pytest.fixture(scope="module")
def landmarks(run, sample, tmp_path_factory):
    """What a reader clicks: the more prominent incisor, the middle of both molars, as a good registration shows them."""
    folder = tmp_path_factory.mktemp("known")
    done = run("register", sample / "case.json", "--output", folder, "--no-report")
    assert done.returncode == 0, done.stderr
    jaws = json.loads((folder / "result.json").read_text())["jaws"]
    marks = {**jaws["upper"]["landmarks_px"], **jaws["lower"]["landmarks_px"]}
    chosen = {}
    for jaw in "UL":
        chosen[f"{jaw}1_tip"] = max(marks[f"{jaw}R1_tip"], marks[f"{jaw}L1_tip"])
        chosen[f"{jaw}6_MB"] = [(a + b) / 2 for a, b in zip(marks[f"{jaw}R6_MB"], marks[f"{jaw}L6_MB"])]
    return chosen


@pytest.fixture
def undrawn(case):
    """The case before anybody drew on it: two scans and a radiograph."""
    content = {key: value for key, value in case.load().items() if key not in ("contours", "traced_side", "landmarks_2d")}
    case.save(content)
    (case.folder / "contours.json").unlink()
    return case


def test_only_the_page_itself_is_answered(program, sample, tmp_path):
    with served(program, sample / "ceph.png", "--output", tmp_path / "out.json") as address:
        status, page = ask(address)
        assert status == 200 and "<svg" in page
        own = f"{data_of(page)['number']}/save"
        # No token, a wrong one, another file.
        assert ask(address, path="/")[0] == 404
        assert ask(address, path="/" + "0" * 32 + "/")[0] == 404
        assert ask(address, path="../out.json")[0] == 404
        # Another name of this machine: what a page elsewhere can make of it.
        assert ask(address, Host="evil.example:80")[0] == 403
        assert ask(address, Sec_Fetch_Site="cross-site")[0] == 403
        # What another page's form or script can send.
        drawing = json.dumps({"contours": None, "landmarks": None})
        assert ask(address, "POST", own, drawing, Origin="http://evil.example")[0] == 403
        assert ask(address, "POST", own, drawing, Content_Type="text/plain")[0] == 403
        assert ask(address, "POST", "/" + "0" * 32 + "/" + own, drawing)[0] == 404
        # What a form or an image of another page can make a browser load.
        assert ask(address, path=own)[0] == 404
        # Of a window that was opened before.
        assert ask(address, "POST", "1/save", drawing)[0] == 409
        assert ask(address, "PUT", own, drawing)[0] in (403, 404)
        # No scans: nothing to register.
        assert ask(address, "POST", own.replace("save", "register"), drawing)[0] == 404
    assert not (tmp_path / "out.json").exists()


def test_listens_on_this_machine_alone(program, sample):
    with served(program, sample / "ceph.png") as address:
        port = urllib.parse.urlsplit(address).port
        listening = [line.split() for name in ("tcp", "tcp6") for line in open(f"/proc/net/{name}").readlines()[1:]]
        places = [line[1] for line in listening if line[3] == "0A" and int(line[1].split(":")[1], 16) == port]
        assert places == [f"0100007F:{port:04X}"]


def test_save_writes_the_named_files_and_no_other(program, sample, tmp_path):
    contours = json.loads((sample / "contours.json").read_text())
    with served(program, sample / "ceph.png", "--output", tmp_path / "c.json", "--landmarks", tmp_path / "l.json") as address:
        status, text = ask(address, "POST", "1/save", json.dumps({"contours": contours, "landmarks": {"U1_tip": [500.25, 400.5]}}))
        assert status == 200, text
    assert json.loads((tmp_path / "c.json").read_text()) == contours
    assert json.loads((tmp_path / "l.json").read_text()) == {"U1_tip": [500.25, 400.5]}
    assert sorted(path.name for path in tmp_path.iterdir()) == ["c.json", "l.json"]


def test_page_that_is_loaded_again_has_what_was_saved(program, sample, tmp_path):
    marks = {"U1_tip": [500.25, 400.5]}
    with served(program, sample / "ceph.png", "--landmarks", tmp_path / "l.json") as address:
        assert ask(address, "POST", "1/save", json.dumps({"contours": None, "landmarks": marks}))[0] == 200
        assert data_of(ask(address)[1])["landmarks"] == marks
        # The first one, which knows nothing of what the second one draws.
        status, text = ask(address, "POST", "1/save", json.dumps({"contours": None, "landmarks": {"L1_tip": [1, 2]}}))
        assert status == 409 and "another window" in json.loads(text)["error"]
        # All deleted: the file holds nothing any more.
        assert ask(address, "POST", "2/save", json.dumps({"contours": None, "landmarks": {}}))[0] == 200
    assert json.loads((tmp_path / "l.json").read_text()) == {}
    with served(program, sample / "ceph.png", "--landmarks", tmp_path / "l.json") as address:
        assert data_of(ask(address)[1])["landmarks"] is None


def test_what_another_program_wrote_is_not_overwritten(program, sample, tmp_path):
    file = tmp_path / "l.json"
    drawing = json.dumps({"contours": None, "landmarks": {"U1_tip": [500.25, 400.5]}})
    with served(program, sample / "ceph.png", "--landmarks", file) as address:
        assert ask(address, "POST", "1/save", drawing)[0] == 200
        file.write_text('{"U1_tip": [1, 2]}')
        status, text = ask(address, "POST", "1/save", drawing)
        assert status == 422 and "l.json" in text and "another program" in text
        assert file.read_text() == '{"U1_tip": [1, 2]}'
        file.unlink()
        assert ask(address, "POST", "1/save", drawing)[0] == 200
    assert json.loads(file.read_text()) == {"U1_tip": [500.25, 400.5]}


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_ends_when_it_is_asked_to(program, undrawn, landmarks, tmp_path, number):
    """At once and well, also while it registers; no process is left."""
    process, address = start(program, "--case", undrawn.file, "--landmarks", tmp_path / "l.json")
    ask(address)
    answers = []

    def register():
        with contextlib.suppress(OSError, http.client.HTTPException):
            answers.append(ask(address, "POST", "1/register", json.dumps({"contours": None, "landmarks": landmarks})))

    asking = threading.Thread(target=register)
    asking.start()
    time.sleep(0.1)
    process.send_signal(number)
    process.communicate(timeout=20)
    asking.join()
    assert process.returncode == 0
    # Done before, ended, or not answered any more.
    assert all(status in (200, 503) for status, _ in answers)
    assert list(tmp_path.glob("*.json")) == []
    with pytest.raises(ConnectionRefusedError):
        ask(address)


def test_signal_before_anybody_asks(program, sample):
    process, _ = start(program, sample / "ceph.png")
    process.send_signal(signal.SIGTERM)
    process.communicate(timeout=20)
    assert process.returncode == 0


def test_ends_with_its_page(program, sample):
    """A page that is loaded again is there in time; one that is closed ends the program."""
    process, address = start(program, sample / "ceph.png")
    ask(address)
    assert ask(address, "POST", "1/closed", "{}")[0] == 200
    ask(address)
    # The page before says it once more: not the one that is open.
    assert ask(address, "POST", "1/closed", "{}")[0] == 200
    time.sleep(7)
    assert process.poll() is None
    assert ask(address, "POST", "2/closed", "{}")[0] == 200
    _, said = process.communicate(timeout=60)
    assert process.returncode == 0 and "The page was closed" in said


def test_what_register_would_refuse_is_not_saved(program, sample, tmp_path):
    (tmp_path / "c.json").write_bytes((sample / "contours.json").read_bytes())
    contours = json.loads((sample / "contours.json").read_text())
    contours["contours"]["upper"][0]["code"] = "LR1"
    with served(program, sample / "ceph.png", "--output", tmp_path / "c.json") as address:
        status, text = ask(address, "POST", "1/save", json.dumps({"contours": contours, "landmarks": None}))
        assert status == 422 and "contours.upper[0].code" in json.loads(text)["error"]
        # By the name that the page has for it, not by that of the file in memory.
        assert json.loads(text)["error"].startswith("contours:"), text
        both = {"contours": json.loads((tmp_path / "c.json").read_text()), "landmarks": {"U1_tip": ["left", 400.5]}}
        status, text = ask(address, "POST", "1/save", json.dumps(both))
        assert status == 422 and json.loads(text)["error"].startswith("landmarks:") and "/proc" not in text, text
        assert ask(address, "POST", "1/save", "no JSON")[0] == 422
    assert (tmp_path / "c.json").read_bytes() == (sample / "contours.json").read_bytes()


def test_registers_as_the_files_do(program, run, undrawn, landmarks, tmp_path):
    """Four marks: what the page is told is what the verb register says of the saved file."""
    with served(program, "--case", undrawn.file, "--landmarks", tmp_path / "l.json") as address:
        status, text = ask(address, "POST", "1/register", json.dumps({"contours": None, "landmarks": landmarks}))
        assert status == 200, text
        told = json.loads(text)
        assert ask(address, "POST", "1/save", json.dumps({"contours": None, "landmarks": landmarks}))[0] == 200
    undrawn.change(cephalometric_landmarks=str(tmp_path / "l.json"))
    done = run("register", undrawn.file, "--output", tmp_path / "result", "--no-report")
    assert done.returncode == 0, done.stderr
    result = json.loads((tmp_path / "result/result.json").read_text())
    assert told["status"] == result["status"]
    for jaw, said in result["jaws"].items():
        assert told["jaws"][jaw]["projection_3x4"] == pytest.approx(sum(said["projection_3x4"], []), rel=1e-9), jaw
        assert [mark["name"] for mark in told["jaws"][jaw]["landmarks_used"]] == [mark for mark in said["landmarks_used"]]
    assert told["traced_side"] == "standard"


def test_drafts_are_where_the_crowns_are(program, sample, undrawn, tmp_path):
    """Registered by its true tracing, the drafts of the traced side lie on it, and those of the other side beside it."""
    contours = json.loads((sample / "contours.json").read_text())
    truth = {entry["code"]: entry["points"] for jaw in contours["contours"].values() for entry in jaw}
    with served(program, "--case", undrawn.file) as address:
        status, text = ask(address, "POST", "1/register", json.dumps({"contours": contours, "landmarks": None}))
        assert status == 200, text
    told = json.loads(text)
    drafts = {draft["code"]: draft["points"] for jaw in told["drafts"].values() for draft in jaw}
    assert {code[:2] for code in drafts} == {"UR", "UL", "LR", "LL"}
    assert len(drafts) >= 20

    def distance(point, line):
        return min(segment_distance(point, a, b) for a, b in zip(line, line[1:]))

    for code, points in truth.items():
        if code in drafts and len(points) > 1:
            away = sorted(distance(point, points) for point in drafts[code])
            # Half of a draft lies on the drawing within its noise; its ends may reach where the hand did not go.
            assert away[len(away) // 2] < 3.0, (code, away)


def test_drafts_do_not_follow_landmarks_that_are_at_another_tooth(program, sample, undrawn):
    """Names of two teeth exchanged, as the registration tells it: without them teeth are found by place along the arch."""
    contours = json.loads((sample / "contours.json").read_text())
    drawn = json.dumps({"contours": contours, "landmarks": None})
    middles = {}
    for kind in ("right", "exchanged", "none"):
        marks = json.loads((sample / "landmarks3d.json").read_text())
        if kind == "exchanged":
            marks["UR4_B"], marks["UR5_B"] = marks["UR5_B"], marks["UR4_B"]
        if kind == "none":
            marks = {name: place for name, place in marks.items() if name[:3] not in ("UR4", "UR5")}
        undrawn.save(marks, "landmarks3d.json")
        with served(program, "--case", undrawn.file) as address:
            status, text = ask(address, "POST", "1/register", drawn)
            assert status == 200, text
        drafts = {draft["code"]: draft["points"] for draft in json.loads(text)["drafts"]["upper"]}
        middles[kind] = {code: sum(u for u, _ in drafts[code]) / len(drafts[code]) for code in ("UR4", "UR5") if code in drafts}
    # The premolar behind lies behind, and where it lies without these landmarks.
    backward = middles["right"]["UR5"] - middles["right"]["UR4"]
    assert abs(backward) > 10
    assert (middles["exchanged"]["UR5"] - middles["exchanged"]["UR4"]) * backward > 0, middles
    assert middles["exchanged"] == pytest.approx(middles["none"], abs=1e-9), middles


def segment_distance(p, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    t = max(0.0, min(1.0, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / ((dx * dx + dy * dy) or 1.0)))
    return ((p[0] - a[0] - t * dx) ** 2 + (p[1] - a[1] - t * dy) ** 2) ** 0.5


def data_of(page):
    return json.loads(re.search(r'id="tracing-data">(.*?)</script>', page, re.S).group(1))


def test_page_by_itself(run, sample, tmp_path):
    done = run("trace", sample / "ceph.png", "--page", tmp_path / "page.html")
    assert done.returncode == 0, done.stderr
    page = (tmp_path / "page.html").read_text()
    assert "connect-src 'none'" in page and "data:image/jpeg" in page
    assert str(sample) not in page


def test_goes_on_with_what_labelme_wrote(run, sample, tmp_path):
    """labelme counts from the pixel's corner, the page from its centre: half a pixel."""
    size = json.loads((sample / "contours.json").read_text())["image_size"]
    shape = {"label": "UR1", "shape_type": "linestrip", "points": [[500.5, 400.5], [510.5, 410.0], [520.5, 400.5]]}
    (tmp_path / "labelme.json").write_text(
        json.dumps({"version": "5.0", "shapes": [shape], "imagePath": "ceph.png", "imageWidth": size[0], "imageHeight": size[1]})
    )
    done = run("trace", sample / "ceph.png", "--output", tmp_path / "labelme.json", "--page", tmp_path / "page.html")
    assert done.returncode == 0, done.stderr
    (contour,) = data_of((tmp_path / "page.html").read_text())["contours"]["contours"]["upper"]
    assert contour["code"] == "UR1" and contour["points"] == [[500.0, 400.0], [510.0, 409.5], [520.0, 400.0]]


def test_goes_on_with_what_slicer_wrote(run, sample, tmp_path):
    """Slicer tells millimetres of the pixels' centres, with u and v turned about in its usual frame."""
    node = {
        "type": "Fiducial",
        "coordinateSystem": "LPS",
        "controlPoints": [{"label": "U1_tip", "position": [50.0625, 80.4, 0.0], "positionStatus": "defined"}],
    }
    (tmp_path / "marks.mrk.json").write_text(json.dumps({"markups": [node]}))
    arguments = ("--markups-spacing", 0.125, 0.2, "--landmarks", tmp_path / "marks.mrk.json", "--page", tmp_path / "page.html")
    done = run("trace", sample / "ceph.png", *arguments)
    assert done.returncode == 0, done.stderr
    (place,) = data_of((tmp_path / "page.html").read_text())["landmarks"].values()
    assert place == [pytest.approx(400.5, abs=0.01), pytest.approx(402.0, abs=0.01)]


def test_a_file_of_another_program_is_not_saved_over(program, run, sample, tmp_path):
    """It may hold more than a tracing: it is read, and what is drawn goes to a file of its own."""
    size = json.loads((sample / "contours.json").read_text())["image_size"]
    shapes = [
        {"label": "UR1", "shape_type": "linestrip", "points": [[500.5, 400.5], [510.5, 410.0]]},
        {"label": "U1_tip", "shape_type": "point", "points": [[500.5, 400.5]]},
        {"label": "soft tissue", "shape_type": "linestrip", "points": [[1, 1], [2, 2]]},
    ]
    file = tmp_path / "labelme.json"
    file.write_text(json.dumps({"shapes": shapes, "imagePath": "ceph.png", "imageWidth": size[0], "imageHeight": size[1]}))
    before = file.read_bytes()
    for option, remedy in (("--output", "--contours"), ("--landmarks", "--cephalometric-landmarks")):
        done = run("trace", sample / "ceph.png", option, file)
        assert done.returncode == 2 and "another program" in done.stderr and remedy in done.stderr
    with served(program, sample / "ceph.png", "--contours", file, "--output", tmp_path / "new.json") as address:
        data = data_of(ask(address)[1])
        # Not in the new file yet, which the page has to know.
        assert data["contours"] and data["contours_saved"] is False
        assert ask(address, "POST", f"{data['number']}/save", json.dumps({"contours": data["contours"], "landmarks": None}))[0] == 200
        assert data_of(ask(address)[1])["contours_saved"] is True
    assert file.read_bytes() == before
    assert json.loads((tmp_path / "new.json").read_text())["contours"]["upper"][0]["code"] == "UR1"


@pytest.fixture
def drafted(case):
    """The case as it would be with drafts for a tracing: `call(kept)` marks all but the first `kept` outlines of a jaw."""

    def call(kept, **fields):
        contours = json.loads((case.folder / "contours.json").read_text())
        for jaw in contours["contours"].values():
            for i, contour in enumerate(sorted(jaw, key=lambda contour: -len(contour["points"]))):
                contour["drafted"] = i >= kept
        (case.folder / "contours.json").write_text(json.dumps(contours))
        case.change(**fields)
        return {jaw: [len(c["points"]) for c in outlines if c["drafted"]] for jaw, outlines in contours["contours"].items()}

    return call


@pytest.mark.parametrize("preset", ["robust", "paper"])
def test_register_tells_of_drafts_that_nobody_mended(run, case, drafted, tmp_path, preset):
    drafted(kept=0)
    done = run("register", case.file, "--output", tmp_path / "result", "--no-report", "--preset", preset)
    result = json.loads((tmp_path / "result/result.json").read_text())
    assert result["status"] == "suspect" and done.returncode == 0
    for jaw in ("upper", "lower"):
        (finding,) = [f for f in result["jaws"][jaw]["findings"] if f["code"] == "drafts-unmended"]
        assert finding["severity"] == "suspect" and finding["value"] == 1.0 and finding["limit"] == 0.5
        assert finding["text"].startswith("100 % of this jaw's outlines are drafts")
    assert "are drafts" in done.stdout + done.stderr


def test_drafts_beside_enough_of_a_hand_are_warned_of(run, sample, case, drafted, tmp_path):
    """Less than half of the points: no finding, and the pose is that of the same points."""
    lengths = drafted(kept=4)
    done = run("register", case.file, "--output", tmp_path / "result", "--no-report")
    result = json.loads((tmp_path / "result/result.json").read_text())
    whole = run("register", sample / "case.json", "--output", tmp_path / "whole", "--no-report")
    assert done.returncode == whole.returncode == 0
    other = json.loads((tmp_path / "whole/result.json").read_text())
    for jaw in ("upper", "lower"):
        assert lengths[jaw] and "drafts-unmended" not in [f["code"] for f in result["jaws"][jaw]["findings"]]
        assert result["jaws"][jaw]["status"] == other["jaws"][jaw]["status"]
        assert result["jaws"][jaw]["projection_3x4"] == other["jaws"][jaw]["projection_3x4"]
        assert any(text.startswith(f"{jaw}: ") and "drafts" in text for text in result["warnings"])
    assert not any("drafts" in text for text in other["warnings"])


@pytest.mark.parametrize(
    "arguments, words",
    [
        ([], "there is no radiograph"),
        (["nowhere.png"], "nowhere.png"),
        (["CEPH", "--output", "a.json", "--landmarks", "./a.json"], "file of --output"),
        (["CEPH", "--case", "CASE", "--upper", "u.stl"], "beside a case file"),
    ],
)
def test_unusable_input_is_one_line(run, sample, arguments, words):
    places = {"CEPH": sample / "ceph.png", "CASE": sample / "case.json"}
    done = run("trace", *[places.get(argument, argument) for argument in arguments])
    assert done.returncode == 2
    assert words in done.stderr and done.stderr.count("\n") == 1


def test_port_that_is_taken(run, sample):
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        done = run("trace", sample / "ceph.png", "--port", taken.getsockname()[1])
    assert done.returncode == 2
    assert "--port" in done.stderr and "leave the option out" in done.stderr
