"""What the commands share: options, help, what they read, where output goes."""
