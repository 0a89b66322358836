"""NS: namespaces and custom elements, after the custom-elements proposal of SDFormat 1.7."""
