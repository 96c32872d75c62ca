"""Concealed recordings by another hand (`otherhand.py`) and the diagnoses that many tests ask for, made once."""

import hashlib
import zlib
from contextlib import contextmanager

import once
import otherhand
import pytest

from pipeline.diagnosis import in_memory
from pipeline.diagnosis.drawing import figures
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.engine import make_problem, study
from pipeline.notebook import diagnosis as in_a_notebook
from pipeline.run.samples import read_samples


@pytest.fixture(scope="session")
def conceal(tmp_path_factory: pytest.TempPathFactory):
    """Make (once) a run with the given effects: `conceal("creep", kappa=1.5)` → its folder and the truth."""
    shared = once.place(tmp_path_factory)

    def make(*kinds: str, kappa: float = 1.5, seed: int = 7, rich: bool = True, nuisance: str = "plain"):
        name = f"run-{zlib.crc32(repr((kinds, kappa, seed, rich, nuisance)).encode()) % 10**6}"
        effects = [(kind, kappa) for kind in kinds]
        truth = once.made_once(
            shared, name, lambda: otherhand.recording(shared / "raw", name, effects, seed, rich, nuisance)
        )
        return shared / "raw" / name, truth

    return make


@pytest.fixture(autouse=True)
def undrawn(request, monkeypatch):
    """No page of figures is drawn in a test, which takes 2 s, but by what makes the page for those that look at it."""
    if not request.node.path.name.startswith("test_diagnosis_page"):
        monkeypatch.setattr(figures, "page", lambda study, content, path, mark="": None)


def kept(outcome):
    """A study as it can be written down: what its simulator remembers of terms may be functions."""
    outcome.problem._terms.clear()
    return outcome


@pytest.fixture(scope="session")
def remembered(tmp_path_factory):
    """Within it `diagnose` takes what another test was told of the same recording by the same library."""
    shared, plain = once.place(tmp_path_factory), in_memory.diagnosed

    @contextmanager
    def remember():
        def diagnosed(recorded, without, by, say):
            def make_diagnosis():
                content, outcome = plain(recorded, without, by, say)
                outcome.search.linear.let_go()  # of 100 MB, as before it is drawn
                return content, kept(outcome)

            assert by is None
            digest = hashlib.sha256()
            for each in recorded:
                digest.update(repr((each.run.model_dump_json(), [*each.samples], each.strokes)).encode())
                digest.update(each.samples.to_numpy(float).tobytes())
            return once.made_once(shared, (digest.hexdigest(), sorted(without)), make_diagnosis)

        with pytest.MonkeyPatch.context() as patch:
            for module in (in_a_notebook, in_memory):  # the program may be run anew
                patch.setattr(module, "diagnosed", diagnosed)
            yield

    return remember


@pytest.fixture(scope="session")
def studied(conceal, tmp_path_factory):
    """What the engine finds in a recording of `conceal`, and its run: to each who asks a study of his own."""
    shared = once.place(tmp_path_factory)

    def find(*kinds: str):
        run, samples = read_samples(conceal(*kinds)[0])
        outcome = once.made_once(
            shared, ("study", kinds), lambda: kept(study(make_problem([RecordedRun.cut(run, samples)])))
        )
        return outcome, run, samples

    return find


@pytest.fixture(scope="session")
def problem(conceal):
    """A problem with nothing concealed in it."""
    run, samples = read_samples(conceal()[0])
    return make_problem([RecordedRun.cut(run, samples)])


@pytest.fixture(scope="session")
def one_load(conceal):
    """A problem recorded under one load at one speed without pauses, and its run."""
    run, samples = read_samples(conceal("creep", rich=False)[0])
    return make_problem([RecordedRun.cut(run, samples)]), run
