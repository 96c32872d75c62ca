FLOORS = ["floor", "floor_blind"]


rule floor:
    input:
        "processed/{material}/dataset.parquet",
    output:
        expand("processed/{{material}}/{floor}/{split}-0.predictions.parquet", floor=FLOORS, split=["within", "later"]),
    log:
        "processed/logs/floor-{material}.log",
    resources:
        **NEEDS["floor"],
    params:
        code=fingerprint("pipeline.stages.floor"),
    message:
        "ask what no model of {wildcards.material} can beat"
    shell:
        "exec python -m pipeline.stages.floor {input:q} --out-dir processed/{wildcards.material:q} > {log:q} 2>&1"
