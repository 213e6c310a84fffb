#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    silhouette_entry_points::foreign(bytes);
});
