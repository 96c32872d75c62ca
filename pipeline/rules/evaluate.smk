def fits_of_material(wildcards):
    return list(fits(config["models"], wildcards.material))


rule evaluate:
    input:
        dataset="processed/{material}/dataset.parquet",
        predictions=fits_of_material,
        floors=rules.floor.output,
    output:
        "processed/{material}/metrics.parquet",
    log:
        "processed/logs/evaluate-{material}.log",
    resources:
        **NEEDS["evaluate"],
    params:
        code=fingerprint("pipeline.stages.evaluate"),
    message:
        "evaluate the models of {wildcards.material}"
    shell:
        "exec python -m pipeline.stages.evaluate {input.dataset:q} {input.predictions:q} {input.floors:q}"
        " --out {output:q} > {log:q} 2>&1"
