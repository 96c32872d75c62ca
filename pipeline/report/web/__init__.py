"""HTML that needs no network: one shell for every page, tables that sort, Markdown, a glossary."""
