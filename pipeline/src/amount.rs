//! Large numbers for people.

/// A count with at most three digits before its unit: `812`, `24.1 k`, `1.6 M`.
pub fn short(count: usize) -> String {
    let count = count as f64;
    match count {
        c if c < 1e4 => format!("{c}"),
        c if c < 1e6 => format!("{:.1} k", c / 1e3),
        c if c < 1e9 => format!("{:.1} M", c / 1e6),
        c => format!("{:.1} G", c / 1e9),
    }
}

/// A number of bytes in KiB, MiB or GiB.
pub fn bytes(count: u64) -> String {
    let kibibytes = count as f64 / 1024.0;
    match kibibytes {
        k if k < 1024.0 => format!("{k:.0} KiB"),
        k if k < 1024.0 * 1024.0 => format!("{:.0} MiB", k / 1024.0),
        k => format!("{:.2} GiB", k / 1024.0 / 1024.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_keep_their_meaning() {
        assert_eq!([812, 9_999, 24_100, 1_612_000].map(short), ["812", "9999", "24.1 k", "1.6 M"]);
        assert_eq!([3 << 9, 5 << 20, 3 << 29].map(bytes), ["2 KiB", "5 MiB", "1.50 GiB"]);
    }
}
