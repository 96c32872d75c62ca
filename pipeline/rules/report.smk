def fits_of_inn(wildcards):
    return list(fits(config["models"], wildcards.material, only="inn"))


rule table:
    input:
        "processed/{material}/metrics.parquet",
    output:
        expand("reports/{{material}}/{file}", file=TABLES),
    log:
        "processed/logs/table-{material}.log",
    params:
        titles=TITLES,
        code=fingerprint("pipeline.report.tables"),
    message:
        "write Tables I and II of {wildcards.material}"
    shell:
        "exec python -m pipeline.report.tables {input:q} --titles {params.titles:q}"
        " --out-dir reports/{wildcards.material:q} > {log:q} 2>&1"


rule comparison:
    input:
        "processed/{material}/metrics.parquet",
    output:
        "reports/{material}/comparison.md",
    log:
        "processed/logs/comparison-{material}.log",
    params:
        titles=TITLES,
        code=fingerprint("pipeline.report.comparison"),
    message:
        "compare {wildcards.material} with the paper"
    shell:
        "exec python -m pipeline.report.comparison {input:q} --titles {params.titles:q} --out {output:q} > {log:q} 2>&1"


rule models:
    input:
        "processed/{material}/metrics.parquet",
    output:
        page="reports/{material}/models.md",
        table="reports/{material}/models.csv",
    log:
        "processed/logs/models-{material}.log",
    params:
        titles=TITLES,
        directed=[model for model, settings in config["models"].items() if settings["direction"]],
        code=fingerprint("pipeline.report.models"),
    message:
        "hold the models of {wildcards.material} against its floor"
    shell:
        "exec python -m pipeline.report.models {input:q} --titles {params.titles:q} --directed {params.directed:q}"
        " --out {output.page:q} --table {output.table:q} > {log:q} 2>&1"


rule figures:
    input:
        dataset="processed/{material}/dataset.parquet",
        inn=fits_of_inn,
    output:
        expand("reports/{{material}}/{file}", file=FIGURES),
    log:
        "processed/logs/figures-{material}.log",
    params:
        code=fingerprint("pipeline.report.figures"),
    message:
        "draw Figures 4 and 5 of {wildcards.material}"
    shell:
        "exec python -m pipeline.report.figures {input.dataset:q} --inn {input.inn:q}"
        " --out-dir reports/{wildcards.material:q} > {log:q} 2>&1"


rule metrics:
    input:
        expand("processed/{material}/metrics.parquet", material=MATERIALS),
    output:
        "reports/metrics.csv",
    log:
        "processed/logs/metrics.log",
    params:
        code=fingerprint("pipeline.report.metrics"),
    message:
        "gather the metrics of all materials"
    shell:
        "exec python -m pipeline.report.metrics {input:q} --out {output:q} > {log:q} 2>&1"


rule index:
    input:
        expand("reports/{material}/{file}", material=MATERIALS, file=[*TABLES, *FIGURES, *PAGES]),
        LEAK_FIGURES,
        expand("reports/diagnosis/{run}", run=DIAGNOSED),
    output:
        "reports/index.html",
    log:
        "processed/logs/index.log",
    params:
        materials=MATERIALS,
        runs=DIAGNOSED,
        code=fingerprint("pipeline.report.index"),
    message:
        "write the page that leads to every report"
    shell:
        "exec python -m pipeline.report.index {params.materials:q} --runs {params.runs:q}"
        " --reports reports --out {output:q} > {log:q} 2>&1"
