rule strokes:
    input:
        "processed/{run}/samples.parquet",
    output:
        "processed/{run}/strokes.parquet",
    log:
        "processed/logs/strokes-{run}.log",
    resources:
        **NEEDS["strokes"],
    params:
        code=fingerprint("pipeline.stages.strokes"),
    message:
        "cut {wildcards.run} into strokes"
    shell:
        "exec python -m pipeline.stages.strokes {input:q} --out {output:q} $NOTE_REFUSALS > {log:q} 2>&1"
