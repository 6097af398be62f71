"""``python -m lommel`` is the command line."""

from lommel.cli.main import main

if __name__ == "__main__":
    main(prog_name="python -m lommel")
