"""Parts of pages: a material, a run, the head of the page of all reports, a jump of the zero."""
