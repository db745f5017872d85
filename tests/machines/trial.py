# SPDX-License-Identifier: Apache-2.0
"""Trial of one suite of Debian: runs the commands of a user on a bare system, and collects figures."""

import datetime
import shutil

import readings
from room import Failure, Room, make_base, remove

FILM = "out/tennis_racket.mp4"
RENDER = ["./poinsot", "render", "scenes/tennis_racket.toml", "-o", FILM]  # README.md has this command and the next
TEST = ["./poinsot", "test"]
INSTALLED = ["poinsot", "render", "/usr/share/poinsot/scenes/tennis_racket.toml", "-o", "/home/trial/racket.mp4"]
CLANG = ["env", "CC=clang", "CXX=clang++", "POINSOT_BUILD_DIR=/src/poinsot/build-clang"]


class Trial:
    """Runs the parts that `asked` names, and collects their figures in `report`."""

    def __init__(self, suite, asked, checkout, say):
        self.suite, self.asked, self.checkout, self.say = suite, asked, checkout, say
        self.folder = asked.cache / suite
        self.logs = self.folder / "logs"
        self.build = "build-clang" if asked.clang else "build"
        self.prefix = CLANG if asked.clang else []
        self.report = {"date": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d"),
                       "compiler": "clang" if asked.clang else "gcc", "versions": {}, "commands": {}}

    def run(self):
        shutil.rmtree(self.logs, ignore_errors=True)
        self.logs.mkdir(parents=True)
        try:
            self.say(f"{self.suite}: making a bare system")
            make_base(self.suite, self.asked.mirror, self.folder, self.asked.afresh)
            self.room = Room(self.folder, "room")
            self.room.clone(self.checkout)
            if self.asked.clang:
                self._install("clang")
            for part in ("render", "test", "package"):
                if part in self.asked.only:
                    getattr(self, "_" + part)()
            self._versions()
            self._warnings()
        except Failure as failure:
            self.report["failure"] = str(failure)
        finally:
            if not self.asked.keep:
                for name in ("room", "installed"):
                    remove(self.folder / name)
        return self.report

    def _command(self, name, words, room=None):
        """Runs a command, and stores its figures and its log under `name`."""
        self.say(f"{self.suite}: {' '.join(words)}")
        outcome = (room or self.room).run(words, self.logs / f"{name}.log")
        self.report["commands"][name] = {"status": outcome.status, "seconds": round(outcome.seconds, 1)}
        self.say(f"{self.suite}: exit {outcome.status} after {outcome.seconds:.0f} s")
        return outcome

    def _install(self, *packages, room=None):
        for words in (["update", "-qq"], ["install", "-y", "-qq", "--no-install-recommends", *packages]):
            log = self.logs / "prepare.log"
            if (room or self.room).run(["env", "DEBIAN_FRONTEND=noninteractive", "apt-get", *words], log).status != 0:
                raise Failure(f"apt could not install {' '.join(packages)}; see {log}")

    def _keep(self, inside, name):
        """Copies a file of the room to the logs. Returns its text, or an empty text if the file is missing."""
        source = self.room.path / "src/poinsot" / inside
        if not source.is_file():
            return ""
        shutil.copyfile(source, self.logs / name)
        return source.read_text(errors="replace")

    def _render(self):
        outcome = self._command("render", self.prefix + RENDER)
        self.report["commands"]["render"]["apt_seconds"] = round(readings.apt_seconds(outcome), 1)
        self.report["film"] = self._probe(self.room.path / "src/poinsot" / FILM)

    def _test(self):
        outcome = self._command("test", self.prefix + TEST)
        self.report["commands"]["test"]["apt_seconds"] = round(readings.apt_seconds(outcome), 1)
        summary = readings.ctest_summary(outcome.text)
        log = self._keep(f"{self.build}/Testing/Temporary/LastTest.log", "LastTest.log")
        if summary:
            self.report["tests"] = {"passed": summary["passed"], "failed": summary["failed"],
                                    "skipped": readings.skips(summary["not_run"], log)}
        golden = [f"{self.build}/bin/poinsot", "golden", "tests/golden/golden.toml", "--json", "-o", "/home/trial/golden"]
        self.report["pictures"] = readings.verdicts(self.room.says(*golden))

    def _package(self):
        if self._command("package", self.prefix + ["./poinsot", "package"]).status != 0:
            return
        made = sorted((self.room.path / "src/poinsot" / self.build).glob("*.deb"))
        self.report["packages"] = {deb.name: deb.stat().st_size for deb in made}
        for deb in made:
            shutil.copyfile(deb, self.logs / deb.name)
        program = next((deb for deb in made if deb.name.startswith("poinsot_")), None)
        if program:
            self._use(program)

    def _use(self, deb):
        """Installs the package in a fresh room, and makes a film there."""
        room = Room(self.folder, "installed", debs=False)  # no cache of packages, because the download is measured
        shutil.copy(deb, room.path / "home/trial" / deb.name)
        apt = ["env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "-y", "-qq"]
        self._command("update", [*apt, "update"], room)
        install = [*apt, "install", f"/home/trial/{deb.name}"]
        self._command("download", [*install, "--download-only"], room)
        archives = room.path / "var/cache/apt/archives"
        self.report["download_bytes"] = sum(file.stat().st_size for file in archives.glob("*.deb"))
        before = self._installed_kib(room)
        self._command("install", install, room)
        self.report["installed_bytes"] = (self._installed_kib(room) - before) * 1024
        self._command("film", INSTALLED, room)
        self.report["installed_film"] = self._probe(room.path / "home/trial/racket.mp4")

    @staticmethod
    def _installed_kib(room):
        return sum(int(size) for size in room.says("dpkg-query", "-W", "-f", "${Installed-Size}\n").split())

    def _probe(self, film):
        """Copies a film to the logs, and returns its facts by the room's ffprobe; None if there is no film."""
        if not film.is_file():
            return None
        shutil.copyfile(film, self.logs / film.name)
        if not (self.room.path / "usr/bin/ffprobe").exists():
            self._install("ffmpeg")
        shutil.copyfile(film, self.room.path / "home/trial/probed.mp4")
        return readings.film(self.room.says("ffprobe", "-v", "error", "-select_streams", "v:0", "-count_packets", "-show_entries",
                                            "stream", "-of", "json", "/home/trial/probed.mp4"))

    def _versions(self):
        form = "${Package} ${db:Status-Status} ${Version}\n"
        self.report["versions"] = readings.versions(self.room.says("dpkg-query", "-W", "-f", form))

    def _warnings(self):
        logs = [self._keep(f"{self.build}/{inside}compile.log", f"compile{number}.log")
                for number, inside in enumerate(("", "fuzz/"))]
        self.report["warnings"] = readings.warnings("\n".join(logs))
