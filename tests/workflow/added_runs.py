"""Runs that the workflow's tests add to a project, and which rules a new material asks for."""

import hashlib

from made_recording import recording

LATE = ("evaluate", "table", "comparison", "models", "figures", "material_page")
LATE = dict.fromkeys((*LATE, "leak_figure", "metrics", "index", "left_out"), 1)
OF_A_MATERIAL = {"ingest": 1, "dataset": 1, "floor": 1, "diagnose": 1, "croissant": 1}
OF_A_MATERIAL |= {rule: 1 for rule in LATE if rule != "leak_figure"}


def add_run(project, name, material, samples=None, text=None):
    folder = project.folder / "raw" / name
    folder.mkdir(parents=True)
    string = f"{{material: {material}, radius_mm: 0.4, length_mm: 400, stiffness_n_per_mm: 15}}"
    good = f"run: {name}\nstring: {string}\nrig: {{torsion_zone_mm: 150, separator_mm: 8}}\n"
    (folder / "run.yaml").write_text(good if text is None else text)
    (recording(4) if samples is None else samples).to_parquet(folder / "recording.parquet", index=False)
    return folder


def digest(folder):
    return {
        str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }
