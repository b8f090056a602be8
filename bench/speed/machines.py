"""Machines that are less regular than the joint."""

MACHINES = {}
