"""The environment is whole or not there: what a start finds, makes, keeps, swaps and removes, on the real launcher."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from small_checkout import is_whole, make_checkout, write_wheel

BOTH = {"alpha": 40, "beta": 40}
# a job that imports only when it is told, which is after a swap
LATE = "print('up', flush=True); input(); from alpha import deep; print(deep.VERSION, deep.__file__)"


def test_it_is_made_once_and_anew_when_the_lock_changes(bare):
    first = bare.run("alpha")
    assert first.returncode == 0 and first.stdout.startswith("alpha 1.0"), first.stderr
    old = bare.link.resolve()
    assert is_whole(old, BOTH) and bare.places() == [old]
    again = bare.run("alpha")
    assert again.stdout == first.stdout and again.stderr == ""
    bare.lock("alpha==2.0", "beta==1.0")
    changed = bare.run("alpha")
    new = bare.link.resolve()
    assert changed.stdout == f"alpha 2.0 {new}\n" and new != old
    assert is_whole(new, BOTH) and bare.places() == [new]  # the old one is gone, as nobody used it


def test_a_running_job_keeps_what_it_started_with(checkout):
    old = checkout.link.resolve()
    job = subprocess.Popen(
        checkout.command("python", "-c", LATE),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env=checkout.variables(),
    )
    assert job.stdout.readline() == "up\n"
    checkout.lock("alpha==2.0", "beta==1.0")
    assert checkout.run("alpha").stdout.startswith("alpha 2.0")
    assert checkout.link.resolve() != old and old in checkout.places()
    printed, _ = job.communicate("\n")
    assert printed.startswith("1.0") and str(old) in printed
    assert checkout.run("true").returncode == 0
    assert checkout.places() == [checkout.link.resolve()]


@pytest.mark.skipif(not Path("/proc/self").exists(), reason="only /proc tells what a job was started by")
def test_the_link_waits_for_a_job_that_was_started_by_it(checkout):
    old = checkout.link.resolve()
    command = [checkout.link / "bin" / "python", "-c", LATE]
    job = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    assert job.stdout.readline() == "up\n"
    checkout.lock("alpha==2.0", "beta==1.0")
    done = checkout.run("alpha")
    assert done.stdout.startswith("alpha 2.0") and f"process [{job.pid}]" in done.stderr
    assert checkout.link.resolve() == old
    assert job.communicate("\n")[0].startswith("1.0")
    assert checkout.run("alpha").stderr == ""
    assert checkout.link.resolve() != old and checkout.places() == [checkout.link.resolve()]


def test_an_environment_of_the_old_kind_is_replaced(checkout):
    place = checkout.link.resolve()
    checkout.link.unlink()
    place.rename(checkout.link)
    (checkout.link / "stamp").write_text("0" * 64)
    assert checkout.run("alpha").returncode == 0
    assert checkout.link.is_symlink() and is_whole(checkout.link.resolve(), BOTH)
    assert checkout.places() == [checkout.link.resolve()]


def test_without_the_packages_the_old_one_stays_and_it_says_so(checkout):
    old = checkout.link.resolve()
    lock = (checkout.env / "requirements.lock").read_text()
    checkout.lock("alpha==9.9", "beta==1.0")
    done = checkout.run("alpha")
    assert done.returncode == 1 and "installing failed" in done.stderr and "Traceback" not in done.stderr
    assert "env/.venv still holds the environment from before" in done.stderr
    assert is_whole(old, BOTH) and checkout.places() == [old] and checkout.link.resolve() == old
    checkout.lock(*lock.splitlines())
    assert checkout.run("alpha").stderr == ""


def test_another_pythons_environment_stays_and_the_link_with_it(checkout):
    other = checkout.link.resolve()
    content = json.loads((other / "stamp").read_text())
    (other / "stamp").write_text(json.dumps({**content, "python": "cpython-399-linux-x86_64"}))
    assert checkout.run("alpha").stdout.startswith("alpha 1.0")
    (mine,) = set(checkout.places()) - {other}
    assert is_whole(mine, BOTH) and is_whole(other, BOTH) and checkout.link.resolve() == other
    assert str(mine) in checkout.run("alpha").stdout
    moved = checkout.folder.rename(checkout.folder.with_name("moved"))
    checkout.folder = moved
    assert checkout.run("alpha").stdout.startswith("alpha 1.0")
    assert {path.name for path in checkout.places()} == {mine.name, other.name}  # the other can be fitted too
    assert checkout.link.resolve().name == mine.name


def test_what_the_installer_leaves_out_or_spoils_is_not_stamped(bare):
    wheels = bare.wheels
    write_wheel(wheels, "alpha", "3.0", spoiled=True)
    bare.lock("alpha==3.0", "beta==1.0")
    done = bare.run("alpha")
    assert done.returncode == 1 and "not whole: alpha: part_7.py differs from its record" in done.stderr
    assert not bare.places() and not os.path.lexists(bare.link)


def test_a_start_notices_a_lost_package_and_makes_it_anew(checkout):
    place = checkout.link.resolve()
    shutil.rmtree(next(place.glob("lib/python*/site-packages")) / "beta")
    done = checkout.run("beta")
    assert "is damaged: beta is missing" in done.stderr and done.stdout.startswith("beta 1.0")
    assert is_whole(checkout.link.resolve(), BOTH) and place not in checkout.places()


@pytest.mark.parametrize(("spoil", "word"), [(Path.unlink, "missing"), (lambda path: path.write_text("x"), "size")])
def test_a_start_notices_a_lost_file_of_a_package_and_its_record(checkout, spoil, word):
    place = checkout.link.resolve()
    site = next(place.glob("lib/python*/site-packages"))
    spoil(site / "alpha-1.0.dist-info" / "RECORD")
    assert "is damaged: alpha-1.0.dist-info" in checkout.run("alpha").stderr, word
    assert is_whole(checkout.link.resolve(), BOTH)


def test_a_check_reads_every_file(checkout):
    whole = checkout.run("--check")
    assert whole.returncode == 0 and "is whole" in whole.stdout and whole.stderr == ""
    place = checkout.link.resolve()
    deep = next(place.glob("lib/python*/site-packages")) / "alpha" / "deep" / "data.bin"
    deep.write_text("y" + "x" * 99_999)
    assert checkout.run("true").stderr == ""  # a start looks at the outline alone
    done = checkout.run("--check")
    assert done.returncode == 0 and "alpha: data.bin differs from its record" in done.stderr
    assert is_whole(checkout.link.resolve(), BOTH) and checkout.link.resolve() != place


def test_what_a_person_adds_is_no_damage(checkout):
    python = str(checkout.link / "bin" / "python")
    write_wheel(checkout.wheels, "gamma", "1.0")
    subprocess.run([python, "-m", "pip", "install", "-q", "gamma"], env=checkout.variables(), check=True)
    assert checkout.run("gamma").stderr == ""


@pytest.mark.parametrize("name", ["moved", "moved to a path with spaces", "x" * 120])
def test_a_moved_checkout_is_fitted_to_its_new_place(checkout, tmp_path, name):
    folder = tmp_path / name
    checkout.folder.rename(folder)
    checkout.folder = folder
    done = checkout.run("alpha")
    place = checkout.link.resolve()
    assert done.stdout == f"alpha 1.0 {place}\n" and place.is_relative_to(folder)
    assert "was moved" in done.stderr and "making" not in done.stderr
    assert is_whole(place, BOTH)
    assert checkout.run("--check").stderr == "" and checkout.places() == [place]
    script = '. "$1" && alpha && python -c "import os; print(os.environ[\'SNAKEMAKE_PROFILE\'])"'
    command = ["bash", "-ec", script, "bash", str(checkout.link / "bin" / "activate")]
    activated = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
    assert activated == [f"alpha 1.0 {place}", str(checkout.env / "profile")]


def test_a_path_with_spaces_works(tmp_path, quick):
    checkout = make_checkout(tmp_path / "a lab's folder" / "project", quick)
    assert checkout.run("alpha").stdout == f"alpha 1.0 {checkout.link.resolve()}\n"
    script = '. "$1" && alpha && test -d "$SNAKEMAKE_PROFILE"'
    command = ["bash", "-ec", script, "bash", str(checkout.link / "bin" / "activate")]
    assert "alpha 1.0" in subprocess.run(command, capture_output=True, text=True, check=True).stdout


HOSTILE = [f"a{sign}b" for sign in '"$`\\\n\r'] + ['sp a\'ce "q" $(touch PWNED) é']


@pytest.mark.parametrize("linked", [False, True])
@pytest.mark.parametrize("name", HOSTILE)
def test_a_path_that_a_shell_would_act_on_is_refused_before_anything_is_made(tmp_path, quick, name, linked):
    checkout = make_checkout(tmp_path / name / "project", quick)
    if linked:
        (tmp_path / "plain").symlink_to(checkout.folder)
        checkout.folder = tmp_path / "plain"
    before = sorted(tmp_path.rglob("*"))
    done = checkout.run("alpha")
    assert done.returncode == 1 and done.stdout == ""
    assert "a shell would act on a sign in this path; move or rename" in done.stderr
    assert done.stderr.count("\n") == 1 and sorted(tmp_path.rglob("*")) == before


def test_a_path_with_an_accent_an_apostrophe_and_signs_that_no_shell_acts_on_in_quotes_works(tmp_path, quick):
    checkout = make_checkout(tmp_path / "l'été (a) & b; #1 *" / "project", quick)
    assert checkout.run("alpha").stdout == f"alpha 1.0 {checkout.link.resolve()}\n"
    activate = str(checkout.link / "bin" / "activate")
    done = subprocess.run(["bash", "-ec", '. "$1" && alpha', "bash", activate], capture_output=True, text=True)
    assert done.returncode == 0 and "alpha 1.0" in done.stdout, done.stderr


def test_a_link_to_another_checkouts_environment_is_used_and_left_alone(checkout, bare, tmp_path):
    other = make_checkout(tmp_path / "other" / "project", bare.quick)
    other.wheels, place = checkout.wheels, checkout.link.resolve()
    other.link.symlink_to(checkout.link)
    done = other.run("alpha")
    assert done.stdout == f"alpha 1.0 {place}\n" and not other.places()
    other.lock("alpha==2.0", "beta==1.0")
    assert other.run("alpha").stdout.startswith("alpha 2.0")
    assert is_whole(place, BOTH) and other.link.resolve() == other.places()[0]


def without_rights_over_files():
    """Bind root too by permissions, as everybody else is: in the child, before the program."""
    if sys.platform == "linux" and os.geteuid() == 0:
        import ctypes

        for right in (1, 2):  # CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH
            assert ctypes.CDLL(None).prctl(24, right, 0, 0, 0) == 0  # PR_CAPBSET_DROP


@pytest.mark.parametrize("has_environment", [True, False])
def test_where_nothing_may_be_written_it_works_or_says_so(checkout, bare, has_environment):
    working_copy = checkout if has_environment else bare
    folders = [
        working_copy.env,
        *(path for path in working_copy.env.rglob("*") if path.is_dir() and not path.is_symlink()),
    ]
    for folder in folders:
        folder.chmod(0o555)
    done = subprocess.run(
        working_copy.command("alpha") if has_environment else working_copy.command("true"),
        capture_output=True,
        text=True,
        env=working_copy.variables(),
        preexec_fn=without_rights_over_files,
    )
    for folder in folders:
        folder.chmod(0o755)
    assert "Traceback" not in done.stderr
    if has_environment:
        assert done.returncode == 0 and done.stdout.startswith("alpha 1.0")
    else:
        assert done.returncode == 1 and "Permission denied" in done.stderr and "writable" in done.stderr


@pytest.mark.long
def test_a_full_disk_is_a_sentence_and_leaves_nothing(bare):
    write_wheel(bare.wheels, "huge", "1.0", files=3000)
    bare.lock("huge==1.0")
    limit = "import resource, os, sys; resource.setrlimit(resource.RLIMIT_FSIZE, (50_000, 50_000)); "
    limit += "import signal; signal.signal(signal.SIGXFSZ, signal.SIG_IGN); os.execv(sys.argv[1], sys.argv[1:])"
    command = [sys.executable, "-c", limit, *bare.command("huge")]
    done = subprocess.run(command, capture_output=True, text=True, env=bare.variables())
    assert done.returncode == 1 and "run.py" not in done.stderr and not bare.places()
