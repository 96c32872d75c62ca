# What the workflow says when it starts, fails and ends: of what it was asked for, what is whole, and nothing else.
def made():
    jobs = [job for job in workflow.dag.jobs if workflow.dag.noneedrun_finished(job)]
    return [str(file) for job in jobs for file in job.output]


onstart:
    for run in PLAN.unfinished:
        print(f"raw/{run}: left out, its recording is unfinished (python -m pipeline.capture --recover raw/{run})")


onerror:
    print(summary(made(), Path("reports"), MATERIALS, DIAGNOSED))
    print("Not all was made: see the errors above. What other runs need is made with --keep-going.")


onsuccess:
    print(summary(made(), Path("reports"), MATERIALS, DIAGNOSED))
