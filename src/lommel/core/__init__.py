"""Interface to the compiled core: functions, results and caches."""
