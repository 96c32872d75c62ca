# A recording goes stale by its content, not by its time; one that a rule makes, when that rule runs. Everything stands
# on recordings, so whoever plans comes by here and learns which files are to be made again whatever their times say.
def recording(wildcards):
    workflow.dag.forcefiles.update(AGAIN)
    files = RECORDED.get(wildcards.run) or recorded_files(RAW, wildcards.run, SYNTHETIC)
    return files if wildcards.run in SYNTHETIC else ancient(files)


def content(wildcards):
    if wildcards.run in SYNTHETIC:
        return ""
    return CONTENT[wildcards.run] if wildcards.run in CONTENT else KNOWN.digest(RECORDED[wildcards.run])


rule ingest:
    input:
        recording,
    output:
        samples="processed/{run}/samples.parquet",
        strokes="processed/{run}/strokes.parquet",
        read_from="processed/{run}/read_from.json",
    log:
        "processed/logs/ingest-{run}.log",
    resources:
        **NEEDS["ingest"],
    params:
        content=content,
        code=fingerprint("pipeline.stages.ingest"),
    message:
        "ingest {wildcards.run}, and cut it into strokes"
    shell:
        "exec python -m pipeline.stages.ingest raw/{wildcards.run:q} --out {output.samples:q}"
        " --out-strokes {output.strokes:q} --out-read-from {output.read_from:q} --read-ahead {READ_AHEAD:q}"
        " --of {params.content:q} {READS:q} $NOTE_REFUSALS > {log:q} 2>&1"
