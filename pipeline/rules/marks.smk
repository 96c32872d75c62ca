from pipeline.report.layout.made_by import NOT_HASHED, called, made_by, unpacked
from pipeline.ground.names import SYNTHETIC as SYNTHETIC_MATERIAL
from pipeline.report.layout.plain_markdown import note
from pipeline.rig.setup_words import other_rig

# Which configuration made what: a mark that every page, table and figure carries.
OPTIONS = set(workflow.config_settings.config) - set(NOT_HASHED)
OTHER_RIG = other_rig(config["synthetic"], DEFAULT["synthetic"])
CALLED = called([str(file) for file in workflow.overwrite_configfiles], bool(OPTIONS))


def mark_of(*parts):
    return made_by(config, DEFAULT, CALLED, list(parts), OTHER_RIG).packed()


def note_of(mark):
    return f"\n{note(unpacked(mark))}\n"


# On the figure of a diagnosis: nothing, unless its recording is of another synthetic rig than the default one.
def mark_of_run(wildcards):
    if wildcards.run not in SYNTHETIC or not OTHER_RIG:
        return []
    mark = unpacked(mark_of("synthetic"))
    return ["--mark", f"recorded by {mark.name} on another synthetic rig: {mark.rig}"]


def mark_of_material(wildcards):
    own = ["synthetic"] if wildcards.material == SYNTHETIC_MATERIAL else []
    return mark_of("models", "keep_lossy", *own)


MARK_OF_ALL = mark_of("models", "keep_lossy", "synthetic", "leak")
