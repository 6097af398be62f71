"""Entry point of ``python -m lommel``, the same as the command ``lommel``."""

from lommel.cli.main import main

if __name__ == "__main__":
    main()
