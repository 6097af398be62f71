"""The compiled core, and what it answers."""
