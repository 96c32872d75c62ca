from snakemake.exceptions import WorkflowError


def runs_of(wildcards):
    if wildcards.material not in PLAN.materials:
        raise WorkflowError(f"no run in raw/ is of material {wildcards.material}, but for those that are left out")
    return PLAN.materials[wildcards.material]


def folders_of_runs(wildcards):
    return expand("raw/{run}", run=runs_of(wildcards))


# What says of runs what they are and when they began: by its content, as a recording.
def described(runs):
    return ancient([file for run in runs for file in RECORDED[run] if Path(file).name in ("run.yaml", "capture.json")])


def stages_of_runs(wildcards):
    runs, stages = runs_of(wildcards), ["samples.parquet", "strokes.parquet", "read_from.json"]
    return described(runs) + expand("processed/{run}/{stage}", run=runs, stage=stages)


rule dataset:
    input:
        stages_of_runs,
    output:
        dataset="processed/{material}/dataset.parquet",
        left_out="processed/{material}/left_out.json",
        jumps="processed/{material}/zero_jumps.json",
        made_from="processed/{material}/made_from.json",
    log:
        "processed/logs/dataset-{material}.log",
    resources:
        **NEEDS["dataset"],
    params:
        runs=folders_of_runs,
        lossy="--keep-lossy" if config["keep_lossy"] else "",
        code=fingerprint("pipeline.stages.dataset"),
    message:
        "make the dataset of {wildcards.material}"
    shell:
        "exec python -m pipeline.stages.dataset {params.runs:q} --processed processed --out {output.dataset:q}"
        " --out-left-out {output.left_out:q} --out-jumps {output.jumps:q} --out-made-from {output.made_from:q}"
        " {params.lossy:q} $NOTE_REFUSALS > {log:q} 2>&1"
