"""The program, which is a package of its own."""

from __future__ import annotations

import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest

from exact_ccd import __main__ as runner

PROGRAM = shutil.which("exact-ccd", path=sysconfig.get_path("scripts"))
SCENE = """
duration = 400.0

[settings]
time-step = 0.02

[[body]]
shape = { box = { cells = [1, 1, 1], size = [1.0, 1.0, 1.0] } }
solid = { density = 1000.0, young = 2e4, poisson = 0.4 }
"""


def test_the_error_names_the_package_of_a_missing_program(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(runner.sysconfig, "get_path", lambda name: "")
    monkeypatch.setenv("PATH", "")
    with pytest.raises(SystemExit) as ended:
        runner.main()
    assert ended.value.code == 2
    assert "`pip install ./crates/exact-ccd-cli`" in capsys.readouterr().err


@pytest.mark.skipif(PROGRAM is None, reason="the program is not installed: pip install ./crates/exact-ccd-cli")
def test_the_module_runs_the_program() -> None:
    of_module = subprocess.run([sys.executable, "-m", "exact_ccd", "--version"], capture_output=True, text=True)
    assert of_module.returncode == 0, of_module.stderr
    of_program = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True)
    assert of_module.stdout == of_program.stdout


@pytest.mark.skipif(PROGRAM is None, reason="the program is not installed: pip install ./crates/exact-ccd-cli")
@pytest.mark.skipif(sys.platform == "win32", reason="signals differ on Windows")
@pytest.mark.parametrize("command", [[PROGRAM], [sys.executable, "-m", "exact_ccd"]], ids=["program", "module"])
def test_ctrl_c_saves_a_simulation(command: list[str], tmp_path: Path) -> None:
    import signal

    (tmp_path / "scene.toml").write_text(SCENE)
    run = subprocess.Popen(
        [*command, "simulate", "scene.toml", "--output", "result"],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        # A background job of a shell inherits that the signal is ignored.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    try:
        # The line of the scene, and one for each of two time steps.
        for _ in range(3):
            run.stdout.readline()
        run.send_signal(signal.SIGINT)
        _, errors = run.communicate(timeout=60.0)
    finally:
        run.kill()
    assert run.returncode == 130, errors
    assert "which is saved; this command continues the run:\n" in errors
    last = int(errors.split("after time step ")[1].split(",")[0])
    rows = (tmp_path / "result" / "statistics.csv").read_text().splitlines()
    assert len(rows) == last + 1, errors
