# The two commands of the README: `make demo` and `make test`. Both set up what they need.
.PHONY: setup demo test lint ci clean
CARGO ?= cargo

demo: setup
	$(CARGO) build --quiet -p assemcad --bin assemcad --example demo
	./target/debug/examples/demo out

test: setup
	$(CARGO) test --quiet --workspace --no-fail-fast

setup:
	@scripts/setup

lint: setup
	$(CARGO) fmt --all --check
	$(CARGO) clippy --quiet --workspace --all-targets -- -D warnings

clean:
	$(CARGO) clean
	rm -rf out .occt .cargo/config.toml
