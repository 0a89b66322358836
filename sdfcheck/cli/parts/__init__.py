"""Shared parts of the commands: options, help, input, where output goes."""
