"""The paper that this package stands on, regenerated: every figure and every number of it."""
