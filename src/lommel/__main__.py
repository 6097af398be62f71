"""``python -m lommel`` is the command line."""

from lommel.cli import main

main(prog_name="python -m lommel")
